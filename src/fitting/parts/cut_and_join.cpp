// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/cut_and_join.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "fitting/parts/extent.h"
#include "fitting/parts/slabs.h"
#include "fitting/search/point_cloud.h"
#include "fitting/shapes/mesh_part.h"
#include "geometry/hulls/convex_hull.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kMostPieces = 24;
constexpr int kDirections = 64;  // for the farthest corners of a piece

/// A piece of the surface, as dense points.
struct Piece {
  std::vector<std::uint32_t> parts;  ///< of the plan; none if it was joined to another
  Points samples;
  PointSummary summary;
  Extent extent;
  double hollow{0.0};  ///< [m] distance of the hull from the surface; 0: nothing to cut
};

/// [m] The greatest distance of points all over the hull from the surface.
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
  piece.summary.corners = extremePoints(samples, directions);
  for (const Vector3d& sample : samples) {
    piece.summary.moments.add(sample);
  }
  piece.samples = std::move(samples);
  piece.extent = extentOf(piece.summary, grid.spacing());
  piece.hollow = hollowOf(convexHullOf(piece.summary.corners), grid);
  return piece;
}

/// The first point in each cell of the grid, so that small triangles give no more points.
Points evenSamples(const DistanceGrid& grid) {
  Points samples;
  std::set<std::array<int, 3>> seen;
  for (const Vector3d& sample : grid.surface()) {
    const Eigen::Array4i cell = grid.inGrid(sample).cast<int>();
    if (seen.insert({cell.x(), cell.y(), cell.z()}).second) {
      samples.push_back(sample);
    }
  }
  return samples;
}

/// The cheapest cut across one axis.
class AxisCut {
 public:
  AxisCut(const Piece& piece, const Vector3d& axis, double layer)
      : piece_(piece), layer_(layer), slabs_(piece.samples, axis) {
    if (!slabs_.canBeCut()) {
      return;
    }
    for (const Vector3d& sample : piece.samples) {
      moments_[slabs_.slabOf(sample)].add(sample);
    }
    constexpr int kStep = 5;
    for (int cut = kStep; cut < Slabs::kCount; cut += kStep) {
      consider(cut);
    }
    for (int cut = best_ - kStep + 1, end = best_ + kStep; best_ > 0 && cut < end; ++cut) {
      consider(cut);
    }
  }

  double cost() const { return cost_; }  ///< infinite where nothing can be cut
  CutPlane plane() const { return slabs_.plane(best_); }

 private:
  /// The bulk of both sides, and a small weight of their length, which decides between equal bulks.
  void consider(int cut) {
    constexpr double kReach = 0.1;
    PointSummary below{slabs_.pointsOf(0, cut), {}};
    PointSummary above{slabs_.pointsOf(cut, Slabs::kCount), piece_.summary.moments};
    if (below.corners.empty() || above.corners.empty()) {
      return;
    }
    for (int slab = 0; slab < cut; ++slab) {
      below.moments.add(moments_[static_cast<std::size_t>(slab)]);
    }
    above.moments.add(below.moments, -1.0);
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
  std::array<Moments, Slabs::kCount> moments_;
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
  std::vector<Piece> pieces{makePiece(0, evenSamples(grid), grid)};
  while (pieces.size() < kMostPieces) {
    throwIfInterrupted();
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

/// Two pieces by position, and how much their joint bulk exceeds the sum of theirs.
struct Join {
  std::size_t a{0};
  std::size_t b{0};
  PointSummary summary;
  Extent extent;
  double growth{0.0};  ///< [m^3]
};

Join joinOf(const std::vector<Piece>& pieces, std::size_t a, std::size_t b, double layer) {
  Join join{a, b, pieces[a].summary, {}, 0.0};
  const PointSummary& other = pieces[b].summary;
  join.summary.corners.insert(join.summary.corners.end(), other.corners.begin(),
                              other.corners.end());
  join.summary.moments.add(other.moments);
  join.extent = extentOf(join.summary, layer);
  join.growth = join.extent.bulk - pieces[a].extent.bulk - pieces[b].extent.bulk;
  return join;
}

/// Joins until `most_shapes` are left and every further join would cost something.
void joinPieces(std::size_t most_shapes, double layer, std::vector<Piece>& pieces) {
  constexpr double kFree = 0.02;  // of the joint bulk
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
    joined.summary = best.summary;
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
