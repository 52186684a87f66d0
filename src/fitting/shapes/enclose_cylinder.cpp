// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "fitting/proofs/proof.h"
#include "fitting/shapes/candidate.h"

namespace collision_monitor {
namespace {

constexpr int kSearchSamples = 150;
constexpr int kGridSteps = 8;

double positivePart(double value) { return value > 0.0 ? value : 0.0; }

Overshoot measureOvershoot(const Shape& shape, const Cylinder& cylinder, int count) {
  OvershootSum sum;
  for (const auto& sample : sampleSurface(shape, count)) {
    const double across = positivePart(sample.point.head<2>().norm() - cylinder.radius);
    const double along = positivePart(std::abs(sample.point.z()) - cylinder.half_length);
    sum.add(std::sqrt(across * across + along * along), sample.area);
  }
  return sum.total();
}

/// The rounded box whose core has a square section and which touches the rims.
RoundedBox roundedBoxAround(const Cylinder& cylinder, double half_width, double half_length) {
  return {{half_width, half_width, half_length},
          std::hypot(cylinder.radius - half_width, cylinder.half_length - half_length)};
}

/// The least coarse rounded box with a core at most `max_half_width` wide. Searches on a grid that
/// is refined around the best point.
RoundedBox searchRoundedBox(const Cylinder& cylinder, double max_half_width) {
  const Eigen::Array2d highest(max_half_width, cylinder.half_length);
  Eigen::Array2d low = Eigen::Array2d::Zero();
  Eigen::Array2d high = highest;
  RoundedBox best = roundedBoxAround(cylinder, 0.0, 0.0);
  double least = coarseness(measureOvershoot(best, cylinder, kSearchSamples));
  constexpr int kRefinements = 4;
  for (int i = 0; i < kRefinements; ++i) {
    const Eigen::Array2d step = (high - low) / kGridSteps;
    for (int width = 0; width <= kGridSteps; ++width) {
      for (int length = 0; length <= kGridSteps; ++length) {
        const Eigen::Array2d at = (low + step * Eigen::Array2d(width, length)).min(highest);
        const RoundedBox box = roundedBoxAround(cylinder, at.x(), at.y());
        const double cost = coarseness(measureOvershoot(box, cylinder, kSearchSamples));
        if (cost < least) {
          least = cost;
          best = box;
        }
      }
    }
    const Eigen::Array2d center(best.half_extents.x(), best.half_extents.z());
    low = (center - step).max(0.0);
    high = (center + step).min(highest);
  }
  return best;
}

}  // namespace

std::vector<Enclosure> encloseCylinder(const Cylinder& cylinder) {
  const RoundedBox capsule = searchRoundedBox(cylinder, 0.0);
  const Eigen::Vector3d half_extents(cylinder.radius, cylinder.radius, cylinder.half_length);
  std::vector<Enclosure> candidates;
  for (const Shape& shape :
       {Shape(Sphere{std::hypot(cylinder.radius, cylinder.half_length)}),
        Shape(Capsule{capsule.half_extents.z(), capsule.radius}), Shape(Box{half_extents}),
        Shape(searchRoundedBox(cylinder, cylinder.radius))}) {
    PosedShape fit{shape, {}};
    Enclosure enclosure;
    enclosure.widening = widenUntilProven(cylinder, fit);
    enclosure.shape = fit.shape;
    enclosure.overshoot = measureOvershoot(fit.shape, cylinder, OvershootSampling{}.count);
    candidates.push_back(enclosure);
  }
  return candidates;
}

}  // namespace collision_monitor
