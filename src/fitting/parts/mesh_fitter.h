// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/parts/choose_cut.h"
#include "fitting/proofs/union_overshoot.h"

namespace collision_monitor {

/// A mesh that is being cut in parts, each with its shape.
class MeshFitter {
 public:
  /// One part: the whole, in the tightest shape. @pre the mesh is sound; it is referred to and must
  /// stay.
  MeshFitter(const TriangleMesh& mesh, const ShapeKinds& kinds);

  /// In another shape, found before.
  MeshFitter(const TriangleMesh& mesh, const Enclosure& whole, const ShapeKinds& kinds);

  /// The overshoot of the part that sticks out farthest of those that can be cut; 0 if none can.
  double worstOvershoot() const noexcept;
  void cutWorst();
  /// Begins anew and finds shapes for what planCuts cuts and joins, at most that many. No more cuts
  /// may follow.
  void cutAndJoin(std::size_t most_shapes, double target);
  /// Whether a cut was made that was worth nothing by itself, or the best fit sticks out far
  /// against the size of the mesh.
  bool isCoarse() const noexcept;
  /// The least coarse of all fits on the way: a cut can make room for the next one only.
  const Fit& best() const noexcept { return best_; }

 private:
  struct Part {
    MeshPart surface;
    Points samples;  ///< of the surface, close together
    Points corners;  ///< whose hull holds the part
    Enclosure enclosure;
    std::vector<MeasuredSample> measured;  ///< none until the shape has been measured
    double slack{0.0};  ///< [m] what the cuts that led to it may have moved its corners by
    bool can_be_cut{true};
  };

  void start(const Enclosure& whole);
  Part wholePart() const;
  std::size_t worstPart() const noexcept;
  bool divide(std::size_t part, const CutPlane& plane);
  RoughGoal goalBeside(std::size_t part) const;
  void encloseAs(const RoughFit& rough, Part& part) const;
  void refit(std::size_t part);
  void measureParts();

  ShapeKinds kinds_;
  TriangleBvh bvh_;
  PartedSurface surface_;
  DistanceGrid grid_;
  std::vector<Part> parts_;
  std::vector<PartCut> cuts_;
  std::vector<std::uint32_t> shape_of_;
  Fit best_;
  double size_{0.0};  ///< [m] the diagonal of the mesh
  bool has_idle_cut_{false};
};

}  // namespace collision_monitor
