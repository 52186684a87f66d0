// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/candidate.h"

namespace collision_monitor {
namespace {

// A costlier shape must be this much tighter. Reasons: docs/decisions/choice-of-shape.md.
constexpr double kWorthwhile = 0.97;

}  // namespace

double coarseness(const Overshoot& overshoot) noexcept { return overshoot.fourth_power_mean; }

Enclosure chooseTightest(const std::vector<Enclosure>& candidates, const ShapeKinds& kinds) {
  const Enclosure* best = nullptr;
  // The variant lists shapes in the order of the cost of their distances.
  for (std::size_t kind = 0; kind < std::variant_size_v<Shape>; ++kind) {
    for (const auto& candidate : candidates) {
      if (candidate.shape.index() != kind || !isAmong(kinds, candidate.shape)) {
        continue;
      }
      const bool is_costlier = best != nullptr && best->shape.index() < kind;
      const double gain = is_costlier ? kWorthwhile : 1.0;
      if (best == nullptr || coarseness(candidate.overshoot) < gain * coarseness(best->overshoot)) {
        best = &candidate;
      }
    }
  }
  return *best;
}

}  // namespace collision_monitor
