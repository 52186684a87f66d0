// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/parts/choose_cut.h"
#include "fitting/proofs/union_overshoot.h"

namespace collision_monitor {

/// A mesh that is cut into parts, each with its shape.
class MeshFitter {
 public:
  /// Starts with one part: the whole in its tightest shape. @pre the mesh is valid and outlives
  /// this.
  MeshFitter(const TriangleMesh& mesh, const ShapeKinds& kinds);

  /// Starts with a shape found before.
  MeshFitter(const TriangleMesh& mesh, const Enclosure& whole, const ShapeKinds& kinds);

  /// The overshoot of the part that sticks out farthest among those that can be cut; 0 if none can.
  double worstOvershoot() const noexcept;
  void cutWorst();
  /// Starts again, and finds at most `most_shapes` shapes for what planCuts cuts and joins. No cuts
  /// may follow.
  void cutAndJoin(std::size_t most_shapes, double target);
  /// Whether a cut gained nothing by itself, or the best fit sticks out far relative to the mesh.
  bool isCoarse() const noexcept;
  /// The best of all fits so far: some cuts only make room for the next one.
  const Fit& best() const noexcept { return best_; }

 private:
  struct Part {
    MeshPart surface;
    Points samples;  ///< of the surface, dense
    Points corners;  ///< whose hull holds the part
    Enclosure enclosure;
    std::vector<MeasuredSample> measured;  ///< empty until the shape has been measured
    double slack{0.0};  ///< [m] upper bound of how far its cuts moved its corners
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
