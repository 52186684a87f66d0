// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/fitting/fit_sphere.h"
#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/fitting/proof.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/candidate.h"
#include "fitting/point_cloud.h"
#include "fitting/small_shapes.h"

namespace collision_monitor {
namespace {

/// Of several fits of one kind, the one that overshoots least, judged roughly.
PosedShape leastCoarse(const std::vector<PosedShape>& fits, const TriangleBvh& mesh) {
  constexpr OvershootSampling kRough{200, 0.05};
  if (fits.size() == 1) {
    return fits.front();
  }
  std::vector<double> costs;
  costs.reserve(fits.size());
  for (const auto& fit : fits) {
    costs.push_back(coarseness(measureOvershoot(fit, mesh, kRough)));
  }
  const auto least = std::min_element(costs.begin(), costs.end()) - costs.begin();
  return fits[static_cast<std::size_t>(least)];
}

}  // namespace

std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh) {
  return encloseMesh(mesh, TriangleBvh(mesh));
}

std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh, const TriangleBvh& bvh) {
  const Points corners = outerPoints(mesh.vertices);
  const auto boxes = smallBoxes(corners);
  const auto capsules = smallCapsules(corners);
  std::vector<PosedShape> fits{fitSphere(corners), leastCoarse(capsules, bvh),
                               leastCoarse(boxes, bvh)};
  const auto rounded_boxes = smallRoundedBoxes(corners, boxes, capsules);
  if (!rounded_boxes.empty()) {
    fits.push_back(leastCoarse(rounded_boxes, bvh));
  }
  std::vector<Enclosure> candidates;
  for (auto& fit : fits) {
    // All vertices, not only the hull's: the proof must not rest on the hull.
    const double widening = widenUntilProven(mesh.vertices, fit);
    const Overshoot overshoot = measureOvershoot(fit, bvh);
    candidates.push_back({fit.shape, fit.geometry_from_body, overshoot, widening, false});
  }
  return candidates;
}

}  // namespace collision_monitor
