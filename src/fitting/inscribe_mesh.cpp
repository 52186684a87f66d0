// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/inscribe_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/closed_surface.h"
#include "fitting/medial_balls.h"
#include "fitting/point_cloud.h"
#include "fitting/segment_clearance.h"
#include "fitting/simplex_search.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSurfacePoints = 200;
constexpr std::size_t kBalls = 16;  // that stand for the inside
constexpr std::size_t kSphereStarts = 4;
constexpr std::size_t kCapsuleStarts = 3;
constexpr int kMaxRounds = 6;
constexpr double kGain = 1e-4;       // a round that gains less is the last
constexpr double kTolerance = 1e-4;  // of distances while searching
constexpr double kAllowance = 1e-9;  // of the mesh's size

/// A segment in the solid and a radius that no sample of it comes below.
struct InnerSegment {
  Vector3d a{Vector3d::Zero()};
  Vector3d b{Vector3d::Zero()};
  double radius{0.0};
  double volume{0.0};
};

class Inscriber {
 public:
  explicit Inscriber(const TriangleMesh& closed_surface) : bvh_(closed_surface) {
    const Aabb& bounds = bvh_.nodes()[0].bounds;
    size_ = (bounds.max - bounds.min).norm();
    balls_ = separateBalls(medialBalls(bvh_, kSurfacePoints), kBalls);
  }

  InnerShapes inscribe() {
    InnerShapes inner;
    for (std::size_t i = 0; i < std::min(kSphereStarts, balls_.size()); ++i) {
      balls_[i] = grown(balls_[i]);
    }
    std::stable_sort(balls_.begin(), balls_.end(),
                     [](const auto& a, const auto& b) { return a.radius > b.radius; });
    for (const auto& ball : balls_) {
      inner.sphere = proven({ball.centre, ball.centre, ball.radius, 0.0}, true);
      if (inner.sphere) {
        break;
      }
    }
    if (inner.sphere) {
      inner.capsule = largestCapsule(std::get<Sphere>(inner.sphere->shape).radius);
    }
    return inner;
  }

 private:
  double distanceAt(const Vector3d& point, double enough) const {
    NearestPoint start;
    start.distance = enough;
    return bvh_.nearestTo(point, start, kTolerance).distance;
  }
  double distanceAt(const Vector3d& point) const {
    return distanceAt(point, std::numeric_limits<double>::infinity());
  }

  /// Moves a ball to where it can be larger. Steps stay in the ball, and so in the solid.
  EmptyBall grown(EmptyBall ball) const {
    for (int round = 0; round < kMaxRounds; ++round) {
      const double unit = ball.radius;
      const auto cost = [&](const Vector3d& step) {
        return step.norm() < 1.0 ? -distanceAt(ball.centre + unit * step) / unit : 0.0;
      };
      const Vector3d step = searchSimplex<3>({round == 0 ? 0.3 : 0.05, 1e-7, 150}, cost);
      const Vector3d centre = ball.centre + unit * step;
      ball = {centre, bvh_.nearestTo(centre).distance};
      if (ball.radius < unit * (1.0 + kGain)) {
        break;
      }
    }
    return ball;
  }

  /// The capsule on a segment, by balls along it of which each reaches the next: one that
  /// starts inside stays inside. Radius 0 when the segment comes near the surface or crosses it.
  InnerSegment along(const Vector3d& a, const Vector3d& b) const {
    constexpr double kSteps = 8.0;
    constexpr double kNear = 0.1;  // of the largest ball: not worth looking at
    InnerSegment segment{a, b, std::numeric_limits<double>::infinity(), 0.0};
    const double length = (b - a).norm();
    double place = 0.0;
    for (bool is_end = false; !is_end;) {
      is_end = place >= length;
      const Vector3d point = is_end ? b : Vector3d(a + place / length * (b - a));
      const double distance = distanceAt(point);
      segment.radius = std::min(segment.radius, distance);
      if (!(distance > kNear * balls_.front().radius)) {
        return {a, b, 0.0, 0.0};
      }
      place += std::min(distance, length / kSteps);
    }
    const double r = segment.radius;
    segment.volume = kPi * r * r * (length + 4.0 / 3.0 * r);
    return segment;
  }

  /// Moves both ends to where the capsule can be larger.
  InnerSegment grown(InnerSegment segment) const {
    using Step = Eigen::Matrix<double, 6, 1>;
    for (int round = 0; round < kMaxRounds; ++round) {
      const InnerSegment start = segment;
      const double unit = distanceAt(start.a);
      const auto moved = [&](const Step& step) {
        return along(start.a + unit * step.head<3>(), start.b + unit * step.tail<3>());
      };
      const auto cost = [&](const Step& step) {
        // The chain of balls starts at a; the first ball must be known to be inside.
        return step.head<3>().norm() < 1.0 ? -moved(step).volume / start.volume : 0.0;
      };
      segment = moved(searchSimplex<6>({round == 0 ? 0.3 : 0.1, 1e-5, 200}, cost));
      if (segment.volume < start.volume * (1.0 + kGain * 10.0)) {
        return segment.volume > start.volume ? segment : start;
      }
    }
    return segment;
  }

  /// Segments between the balls, and short ones in the largest along the axes of the mesh.
  std::vector<InnerSegment> capsuleStarts() const {
    std::vector<InnerSegment> starts;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t j = i + 1; j < balls_.size(); ++j) {
        starts.push_back(along(balls_[i].centre, balls_[j].centre));
      }
    }
    const EmptyBall& largest = balls_.front();
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d half = 0.25 * largest.radius * Vector3d::Unit(axis);
      starts.push_back(along(largest.centre - half, largest.centre + half));
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const auto& a, const auto& b) { return a.volume > b.volume; });
    starts.resize(std::min(starts.size(), kCapsuleStarts));
    return starts;
  }

  std::optional<PosedShape> largestCapsule(double sphere_radius) const {
    std::optional<PosedShape> best =
        proven({balls_.front().centre, balls_.front().centre, sphere_radius, 0.0}, false);
    double best_volume = best ? volumeOf(best->shape) : 0.0;
    for (const auto& start : capsuleStarts()) {
      const auto capsule = start.volume > 0.0 ? proven(grown(start), false) : std::nullopt;
      if (capsule && volumeOf(capsule->shape) > best_volume) {
        best = capsule;
        best_volume = volumeOf(best->shape);
      }
    }
    return best;
  }

  /// The shape with the radius that can be proven, if any can.
  std::optional<PosedShape> proven(const InnerSegment& segment, bool is_sphere) const {
    PosedShape fit;
    const Vector3d along = 0.5 * segment.b - 0.5 * segment.a;
    double half_length = is_sphere ? 0.0 : along.norm();
    fit.geometry_from_body.translation = 0.5 * segment.a + 0.5 * segment.b;
    if (half_length > 0.0) {
      fit.geometry_from_body.rotation = rotationWithAxis(along / half_length);
    }
    // As it is stored, not as it was meant.
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
