// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_winding.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "narrow_phase/mesh/mesh_search.h"

namespace collision_monitor {
namespace {

// Rounding of a sum of up to 1e7 solid angles.
constexpr double kRounding = 1e-9;

// Sums all parts. A part counts by its moments or, if their error exceeds `most_of_part`, by its
// own parts. Stops with the sum so far once the error exceeds `most_of_all`.
WindingNumber sum(const MeshTree& tree, const Eigen::Vector3d& point, double most_of_part,
                  double most_of_all, MeshQueryMemory& memory) noexcept {
  const std::vector<WindingMoments>& moments = tree.openSurface()->moments;
  WindingNumber number{0.0, kRounding, 0};
  SolidAngles angles(point);
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  while (!queue.empty() && number.error <= most_of_all) {
    const std::uint32_t node = queue.pop().a;
    ++number.visits;
    const BoundedNumber part = windingOf(moments[node], point);
    if (part.error <= most_of_part) {
      number.value += part.value;
      number.error += part.error;
      continue;
    }
    for (const std::uint32_t child : tree.nodes()[node].child) {
      if (child == kNone) {
        continue;
      }
      if (isTriangle(child)) {
        angles.add(tree.triangles()[triangleAt(child)]);
        ++number.visits;
      } else {
        queue.push({0.0F, child, 0});
      }
    }
  }
  number.value += angles.sum() / (4.0 * kPi);
  return number;
}

// Searches from coarse to fine. A number with an error above `most` never suffices.
template <class ReachesCutoff>
WindingNumber search(const MeshTree& tree, const Eigen::Vector3d& point, double most,
                     MeshQueryMemory& memory, const ReachesCutoff& reachesCutoff) noexcept {
  constexpr double kCoarsest = 0x1p-6;
  constexpr double kStep = 0x1p-3;
  std::uint32_t visits = 0;
  double most_of_part = kCoarsest;
  WindingNumber number;
  do {
    number = sum(tree, point, most_of_part, most, memory);
    visits += number.visits;
    most_of_part *= kStep;
  } while (number.error > kRounding && !reachesCutoff(number));
  number.visits = visits;
  return number;
}

}  // namespace

WindingNumber windingNumber(const MeshTree& tree, const Eigen::Vector3d& point, double error,
                            MeshQueryMemory& memory) noexcept {
  return search(tree, point, std::max(error, kRounding), memory,
                [&](const WindingNumber& number) { return number.error <= error; });
}

WindingNumber windingByHalf(const MeshTree& tree, const Eigen::Vector3d& point, double error,
                            MeshQueryMemory& memory) noexcept {
  return search(tree, point, kInfinity, memory, [&](const WindingNumber& number) {
    return number.error <= error || std::abs(std::abs(number.value) - 0.5) > number.error;
  });
}

}  // namespace collision_monitor
