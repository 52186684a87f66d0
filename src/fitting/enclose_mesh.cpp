// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_box.h"
#include "collision_monitor/fitting/fit_capsule.h"
#include "collision_monitor/fitting/fit_rounded_box.h"
#include "collision_monitor/fitting/fit_sphere.h"
#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/fitting/proof.h"
#include "collision_monitor/geometry/convex_hull.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/candidate.h"

namespace collision_monitor {

std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh) {
  const TriangleBvh bvh(mesh);
  const Points corners = convexHullOf(mesh.vertices).vertices;
  std::vector<Enclosure> candidates;
  for (PosedShape fit :
       {fitSphere(corners), fitCapsule(corners), fitBox(corners), fitRoundedBox(corners)}) {
    // All vertices, not only the hull's: the proof must not rest on the hull.
    const double widening = widenUntilProven(mesh.vertices, fit);
    const Overshoot overshoot = measureOvershoot(fit, bvh, kSampleCount);
    candidates.push_back({fit.shape, fit.geometry_from_body, overshoot, widening, false});
  }
  return candidates;
}

}  // namespace collision_monitor
