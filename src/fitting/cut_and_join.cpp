// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/cut_and_join.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "collision_monitor/geometry/convex_hull.h"
#include "fitting/mesh_part.h"
#include "fitting/point_cloud.h"
#include "fitting/slabs.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kMostPieces = 24;
constexpr int kDirections = 64;  // in which the corners of a piece are farthest

/// Of points.
struct Extent {
  double bulk{0.0};    ///< [m^3] of their hull and of a box about them: what their shape may hold
  double length{0.0};  ///< [m] of the diagonal of the box
};

/// Points of the surface, close together, and what surrounds them.
struct Piece {
  std::vector<std::uint32_t> parts;  ///< of the plan
  Points samples;
  Points corners;  ///< the farthest of the samples
  Extent extent;
  double hollow{0.0};  ///< [m] how far the hull is from the surface; 0: nothing to cut
};

/// [m^3] With half a layer all around.
double volumeOf(const TriangleMesh& hull, double layer) {
  double volume = 0.0;
  double area = 0.0;
  for (const auto& t : hull.triangles) {
    const Vector3d& a = hull.vertices[t[0]];
    const Vector3d twice_area = (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a);
    volume += a.dot(twice_area) / 6.0;
    area += 0.5 * twice_area.norm();
  }
  return volume + 0.5 * layer * area;
}

/// The box is the smaller of two: along the axes of the frame, or along those of the points.
/// @param layer [m] by which samples are apart: half of it is added all around, so that what lies
/// between samples on both sides of a cut is not lost, and what is flat counts.
Extent extentOf(const Points& points, double layer) {
  double box = std::numeric_limits<double>::infinity();
  double length = 0.0;
  for (const Matrix3d& frame : {Matrix3d(Matrix3d::Identity()), principalAxes(points)}) {
    Vector3d low = frame.transpose() * points.front();
    Vector3d high = low;
    for (const Vector3d& point : points) {
      const Vector3d in_frame = frame.transpose() * point;
      low = low.cwiseMin(in_frame);
      high = high.cwiseMax(in_frame);
    }
    const Vector3d sides = (high - low).array() + layer;
    if (sides.prod() < box) {
      box = sides.prod();
      length = sides.norm();
    }
  }
  return {volumeOf(convexHullOf(points), layer) + box, length};
}

/// [m] How far points all over the hull are from the surface, at most.
double hollowOf(const TriangleMesh& hull, const DistanceGrid& grid) {
  constexpr int kAcross = 6;
  double farthest = 0.0;
  for (const auto& t : hull.triangles) {
    for (int i = 0; i <= kAcross; ++i) {
      for (int k = 0; k <= kAcross - i; ++k) {
        const Vector3d point = (i * hull.vertices[t[0]] + k * hull.vertices[t[1]] +
                                (kAcross - i - k) * hull.vertices[t[2]]) /
                               kAcross;
        farthest = std::max(farthest, grid.distanceTo(point));
      }
    }
  }
  return farthest;
}

Piece makePiece(std::uint32_t part, Points samples, const DistanceGrid& grid) {
  static const Points directions = spreadDirections(kDirections);
  Piece piece;
  piece.parts = {part};
  piece.corners = extremePoints(samples, directions);
  piece.samples = std::move(samples);
  piece.extent = extentOf(piece.corners, grid.spacing());
  piece.hollow = hollowOf(convexHullOf(piece.corners), grid);
  return piece;
}

/// The cheapest cut across one axis.
class AxisCut {
 public:
  AxisCut(const Piece& piece, const Vector3d& axis, double layer)
      : piece_(piece), layer_(layer), slabs_(piece.samples, axis) {
    constexpr int kStep = 5;
    for (int cut = kStep; slabs_.canBeCut() && cut < Slabs::kCount; cut += kStep) {
      consider(cut);
    }
    for (int cut = best_ - kStep + 1, end = best_ + kStep; best_ > 0 && cut < end; ++cut) {
      consider(cut);
    }
  }

  double cost() const { return cost_; }  ///< infinite where nothing can be cut
  CutPlane plane() const { return slabs_.plane(best_); }

 private:
  /// What is left, and how far it still reaches where that is all the same.
  void consider(int cut) {
    constexpr double kReach = 0.1;
    const Points below = slabs_.pointsOf(0, cut);
    const Points above = slabs_.pointsOf(cut, Slabs::kCount);
    if (below.empty() || above.empty()) {
      return;
    }
    const Extent& whole = piece_.extent;
    const Extent one = extentOf(below, layer_);
    const Extent other = extentOf(above, layer_);
    const double cost = one.bulk + other.bulk +
                        kReach * whole.bulk * std::max(one.length, other.length) / whole.length;
    if (cost < cost_) {
      cost_ = cost;
      best_ = cut;
    }
  }

  const Piece& piece_;
  double layer_;
  Slabs slabs_;
  int best_{0};
  double cost_{std::numeric_limits<double>::infinity()};
};

std::optional<CutPlane> cheapestCut(const Piece& piece, double layer) {
  std::optional<CutPlane> plane;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3d& axis : distinctAxes({Matrix3d::Identity(), principalAxes(piece.samples)})) {
    const AxisCut cut(piece, axis, layer);
    if (cut.cost() < least) {
      least = cut.cost();
      plane = cut.plane();
    }
  }
  return plane;
}

std::vector<Piece> cutToPieces(const DistanceGrid& grid, double target,
                               std::vector<PartCut>& cuts) {
  constexpr double kGridError = 1.5;  // spacings
  const double tolerance = std::max(target, kGridError * grid.spacing());
  std::vector<Piece> pieces{makePiece(0, grid.surface(), grid)};
  while (pieces.size() < kMostPieces) {
    const auto worst =
        std::max_element(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.hollow < b.hollow; });
    if (!(worst->hollow > tolerance)) {
      break;
    }
    const std::optional<CutPlane> plane = cheapestCut(*worst, grid.spacing());
    Points below;
    Points above;
    for (const Vector3d& sample : worst->samples) {
      (plane && plane->heightOf(sample) <= 0.0 ? below : above).push_back(sample);
    }
    if (below.empty() || above.empty()) {
      worst->hollow = 0.0;
      continue;
    }
    const std::uint32_t part = worst->parts.front();
    cuts.push_back({part, plane->normal, plane->offset});
    *worst = makePiece(part, std::move(below), grid);
    pieces.push_back(makePiece(static_cast<std::uint32_t>(pieces.size()), std::move(above), grid));
  }
  return pieces;
}

/// Two pieces, by position, and by how much their common bulk exceeds theirs.
struct Join {
  std::size_t a{0};
  std::size_t b{0};
  Points corners;
  Extent extent;
  double growth{0.0};  ///< [m^3]
};

Join joinOf(const std::vector<Piece>& pieces, std::size_t a, std::size_t b, double layer) {
  Join join{a, b, pieces[a].corners, {}, 0.0};
  join.corners.insert(join.corners.end(), pieces[b].corners.begin(), pieces[b].corners.end());
  join.extent = extentOf(join.corners, layer);
  join.growth = join.extent.bulk - pieces[a].extent.bulk - pieces[b].extent.bulk;
  return join;
}

/// Joins until `most_shapes` are left and more would cost something. Pieces without parts are gone.
void joinPieces(std::size_t most_shapes, double layer, std::vector<Piece>& pieces) {
  constexpr double kFree = 0.02;  // of the common bulk
  std::vector<Join> joins;
  for (std::size_t b = 0; b < pieces.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      joins.push_back(joinOf(pieces, a, b, layer));
    }
  }
  for (std::size_t left = pieces.size(); !joins.empty(); --left) {
    const auto found =
        std::min_element(joins.begin(), joins.end(),
                         [](const Join& x, const Join& y) { return x.growth < y.growth; });
    if (left <= most_shapes && found->growth > kFree * found->extent.bulk) {
      return;
    }
    const Join best = std::move(*found);
    Piece& joined = pieces[best.a];
    Piece& gone = pieces[best.b];
    joined.parts.insert(joined.parts.end(), gone.parts.begin(), gone.parts.end());
    joined.corners = best.corners;
    joined.extent = best.extent;
    gone.parts.clear();
    const auto isOfThem = [&](const Join& join) {
      return join.a == best.a || join.a == best.b || join.b == best.a || join.b == best.b;
    };
    joins.erase(std::remove_if(joins.begin(), joins.end(), isOfThem), joins.end());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i != best.a && !pieces[i].parts.empty()) {
        joins.push_back(joinOf(pieces, best.a, i, layer));
      }
    }
  }
}

}  // namespace

CutPlan planCuts(const DistanceGrid& grid, std::size_t most_shapes, double target) {
  CutPlan plan;
  std::vector<Piece> pieces = cutToPieces(grid, target, plan.cuts);
  joinPieces(most_shapes, grid.spacing(), pieces);
  plan.shape_of.resize(pieces.size());
  plan.shapes = 0;
  for (const Piece& piece : pieces) {
    for (const std::uint32_t part : piece.parts) {
      plan.shape_of[part] = static_cast<std::uint32_t>(plan.shapes);
    }
    plan.shapes += piece.parts.empty() ? 0 : 1;
  }
  return plan;
}

}  // namespace collision_monitor
