// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/inner/inscribe_mesh.h"

#include <algorithm>
#include <cmath>

#include "fitting/inner/grow_inside.h"
#include "fitting/inner/medial_balls.h"
#include "fitting/proofs/closed_surface.h"
#include "fitting/proofs/segment_clearance.h"
#include "fitting/search/point_cloud.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr int kSurfacePoints = 150;
constexpr std::size_t kBalls = 10;  // that represent the inside
constexpr std::size_t kSphereStarts = 3;
constexpr std::size_t kCapsuleStarts = 2;
constexpr double kNear = 0.1;        // of the largest ball: thinner capsules are not tried
constexpr double kAllowance = 1e-9;  // of the mesh's size

void sortByVolume(std::vector<InnerSegment>& segments) {
  std::stable_sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return volumeOf(a) > volumeOf(b); });
}

class Inscriber {
 public:
  explicit Inscriber(const TriangleMesh& closed_surface) : bvh_(closed_surface) {
    const Aabb& bounds = bvh_.bounds();
    size_ = (bounds.max - bounds.min).norm();
    balls_ = separateBalls(medialBalls(bvh_, kSurfacePoints), kBalls);
  }

  InnerShapes inscribe() {
    InnerShapes inner;
    for (std::size_t i = 0; i < std::min(kSphereStarts, balls_.size()); ++i) {
      balls_[i] = growBall(bvh_, balls_[i]);
    }
    std::stable_sort(balls_.begin(), balls_.end(),
                     [](const auto& a, const auto& b) { return a.radius > b.radius; });
    while (!balls_.empty() && !inner.sphere) {
      inner.sphere = proven({balls_[0].center, balls_[0].center, balls_[0].radius}, true);
      if (!inner.sphere) {
        balls_.erase(balls_.begin());
      }
    }
    if (inner.sphere) {
      inner.capsule = largestCapsule();
    }
    return inner;
  }

 private:
  /// Segments between the balls, and short ones in the largest ball along the axes of the mesh.
  std::vector<InnerSegment> capsuleStarts() const {
    std::vector<InnerSegment> starts;
    double best_volume = 0.0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t j = i + 1; j < balls_.size(); ++j) {
        // Balls come largest first, so the second bounds the radius; mesh queries are costly.
        const InnerSegment hoped{balls_[i].center, balls_[j].center, balls_[j].radius};
        if (volumeOf(hoped) > best_volume) {
          starts.push_back(segmentBetween(hoped.a, hoped.b));
          best_volume = std::max(best_volume, volumeOf(starts.back()));
        }
      }
    }
    const EmptyBall& largest = balls_.front();
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d half = 0.25 * largest.radius * Vector3d::Unit(axis);
      starts.push_back(segmentBetween(largest.center - half, largest.center + half));
    }
    sortByVolume(starts);
    starts.resize(std::min(starts.size(), kCapsuleStarts));
    return starts;
  }

  InnerSegment segmentBetween(const Vector3d& a, const Vector3d& b) const {
    return innerSegment(bvh_, a, b, kNear * balls_.front().radius);
  }

  /// The largest capsule that can be proven; a sphere counts as one. Usually the first candidate is
  /// proven, and proofs take longer than searches.
  std::optional<PosedShape> largestCapsule() const {
    const EmptyBall& largest = balls_.front();
    std::vector<InnerSegment> segments{{largest.center, largest.center, largest.radius}};
    for (const auto& start : capsuleStarts()) {
      if (start.radius > 0.0) {
        segments.push_back(growSegment(bvh_, start));
      }
    }
    sortByVolume(segments);
    for (const auto& segment : segments) {
      if (auto capsule = proven(segment, false)) {
        return capsule;
      }
    }
    return std::nullopt;
  }

  /// The shape with the radius that can be proven; none if no radius can.
  std::optional<PosedShape> proven(const InnerSegment& segment, bool is_sphere) const {
    throwIfInterrupted();
    PosedShape fit;
    const Vector3d along = 0.5 * segment.b - 0.5 * segment.a;
    double half_length = is_sphere ? 0.0 : along.norm();
    fit.geometry_from_body.translation = 0.5 * segment.a + 0.5 * segment.b;
    if (half_length > 0.0) {
      fit.geometry_from_body.rotation = rotationWithAxis(along / half_length);
    }
    // Uses the stored numbers, not the intended ones.
    const Vector3d half = fit.geometry_from_body.rotation.col(2) * half_length;
    const Vector3d a = fit.geometry_from_body.translation - half;
    const Vector3d b = fit.geometry_from_body.translation + half;
    const double radius = clearanceBound(bvh_, a, b) - kAllowance * size_;
    if (!(radius > 0.0) || !(std::abs(windingNumber(bvh_, a) - 1.0) < 0.01)) {
      return std::nullopt;
    }
    fit.shape = is_sphere ? Shape(Sphere{radius}) : Shape(Capsule{half_length, radius});
    return fit;
  }

  TriangleBvh bvh_;
  double size_{0.0};
  std::vector<EmptyBall> balls_;
};

}  // namespace

InnerShapes inscribeMesh(const TriangleMesh& mesh) {
  const auto surface = closedSurface(mesh);
  return surface ? Inscriber(*surface).inscribe() : InnerShapes{};
}

}  // namespace collision_monitor
