// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "fitting/proofs/proof.h"
#include "fitting/shapes/candidate.h"

namespace collision_monitor {
namespace {

Overshoot measureOvershoot(const Shape& shape, const Capsule& capsule) {
  OvershootSum sum;
  for (const auto& sample : sampleSurface(shape, OvershootSampling{}.count)) {
    sum.add(std::max(signedDistanceTo(capsule, sample.point), 0.0), sample.area);
  }
  return sum.total();
}

}  // namespace

std::vector<Enclosure> encloseCapsule(const Capsule& capsule) {
  const double reach = capsule.half_length + capsule.radius;
  const Eigen::Vector3d core(0.0, 0.0, capsule.half_length);
  std::vector<Enclosure> candidates;
  for (const Shape& shape :
       {Shape(Sphere{reach}), Shape(capsule), Shape(Box{{capsule.radius, capsule.radius, reach}}),
        Shape(RoundedBox{core, capsule.radius})}) {
    PosedShape fit{shape, {}};
    Enclosure enclosure;
    enclosure.widening = widenUntilProven(capsule, fit);
    enclosure.shape = fit.shape;
    enclosure.overshoot = measureOvershoot(fit.shape, capsule);
    candidates.push_back(enclosure);
  }
  return candidates;
}

}  // namespace collision_monitor
