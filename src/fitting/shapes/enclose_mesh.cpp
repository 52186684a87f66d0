// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/proofs/proof.h"
#include "fitting/search/point_cloud.h"
#include "fitting/search/small_shapes.h"
#include "fitting/shapes/candidate.h"
#include "fitting/shapes/fit_sphere.h"
#include "fitting/shapes/rough_fit.h"

namespace collision_monitor {
namespace {

constexpr double kRealGain = 0.99;  // less may be the grid's error
constexpr double kHopeless = 1.3;   // times the best kind: not worth measuring on the mesh
constexpr double kVisible = 2.0;    // spacings of the grid; smaller overshoot is not resolved
constexpr int kRepresentatives = 120;

/// What a search needs to know of a mesh.
struct Scene {
  const TriangleBvh& mesh;
  const RoughGoal& goal;
  const Points& representatives;

  bool sees(double cost) const { return cost > kVisible * goal.grid.spacing(); }

  /// The measure by which kinds are compared. Units: metres.
  double coarsenessOf(const TurnedCore& core) const {
    return coarseness(goal.overshootOf(core).total());
  }

  double coarsenessOnMesh(const PosedShape& fit) const {
    return coarseness(measureOvershoot(fit, mesh, {200, 0.05}));
  }
};

/// The fit of one kind that overshoots least, moved to where it overshoots even less. Within a kind
/// the maximum counts too.
RoughFit leastCoarse(const std::vector<PosedShape>& fits, const Scene& scene) {
  RoughFit best;
  for (const auto& fit : fits) {
    const TurnedCore core = coreOf(fit);
    double cost = scene.goal.costOf(core);
    if (!scene.sees(cost)) {
      cost = std::min(scene.coarsenessOnMesh(fit), kVisible * scene.goal.grid.spacing());
    }
    if (cost < best.cost) {
      best = {core, fit.shape.index(), cost};
    }
  }
  if (scene.sees(best.cost)) {
    const RoughFit moved = polished(best, scene.representatives, scene.goal);
    best = moved.cost < kRealGain * best.cost ? moved : best;
  }
  best.cost = scene.coarsenessOf(best.core);
  return best;
}

/// The best fit of each allowed kind.
std::vector<RoughFit> fitsOfKinds(const Points& corners, const Scene& scene) {
  const auto boxes = smallBoxes(corners);
  const auto capsules = smallCapsules(corners);
  std::vector<RoughFit> fits;
  for (const auto& kind : {std::vector<PosedShape>{fitSphere(corners)}, capsules, boxes,
                           smallRoundedBoxes(corners, boxes, capsules)}) {
    if (!kind.empty() && isAmong(scene.goal.kinds, kind.front().shape)) {
      fits.push_back(leastCoarse(kind, scene));
    }
  }
  return fits;
}

Enclosure proven(const RoughFit& rough, const TriangleMesh& mesh, const TriangleBvh& bvh) {
  PosedShape fit = placedShape(rough);
  // A search may have seen only some vertices. Tests all vertices, not only the hull's: the proof
  // must not rest on the hull.
  fit.shape = grown(fit.shape, std::max(excessOver(fit, mesh.vertices), 0.0));
  Enclosure enclosure;
  enclosure.widening = widenUntilProven(mesh.vertices, fit);
  enclosure.shape = fit.shape;
  enclosure.geometry_from_body = fit.geometry_from_body;
  enclosure.overshoot = measureOvershoot(fit, bvh);
  return enclosure;
}

}  // namespace

std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh, const ShapeKinds& kinds) {
  return encloseMesh(mesh, TriangleBvh(mesh), DistanceGrid(mesh), kinds);
}

std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh, const TriangleBvh& bvh,
                                   const DistanceGrid& grid, const ShapeKinds& kinds) {
  const Points corners = outerPoints(mesh.vertices);
  const Points representatives = corners.size() <= kRepresentatives
                                     ? corners
                                     : extremePoints(corners, spreadDirections(kRepresentatives));
  const RoughGoal goal{grid, kinds, {}, {}};
  const auto fits = fitsOfKinds(corners, Scene{bvh, goal, representatives});
  const double least = std::min_element(fits.begin(), fits.end(), [](const auto& a, const auto& b) {
                         return a.cost < b.cost;
                       })->cost;
  std::vector<Enclosure> candidates;
  for (const auto& fit : fits) {
    if (fit.cost <= kHopeless * least + 0.5 * grid.spacing()) {
      candidates.push_back(proven(fit, mesh, bvh));
    }
  }
  return candidates;
}

}  // namespace collision_monitor
