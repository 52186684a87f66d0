// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_winding.h"

#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "narrow_phase/mesh/mesh_search.h"

namespace collision_monitor {
namespace {

// Rounding of a sum of up to 1e7 solid angles.
constexpr double kRounding = 1e-9;

// A sum over all parts of a surface. A part counts by its moments or, if their error exceeds a
// limit, by its own parts. Lower limits open the parts that are too coarse for them, not the rest.
class SumOfParts {
 public:
  SumOfParts(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory) noexcept
      : tree_(tree), point_(point), memory_(memory), angles_(point) {}

  void openRoot(double most_of_part) noexcept { open(0, most_of_part); }

  void openCoarse(double most_of_part) noexcept {
    for (std::size_t i = held_; i-- > 0;) {
      const Held part = memory_.node_pairs[i];
      if (static_cast<double>(part.squared_bound) > most_of_part) {
        // The last part moves here. It was looked at before, or is new and fine enough.
        memory_.node_pairs[i] = memory_.node_pairs[--held_];
        const BoundedNumber coarse = momentsAt(part.a);
        of_moments_.value -= coarse.value;
        of_moments_.error -= coarse.error;
        openChildren(part.a, most_of_part);
      }
    }
  }

  WindingNumber number() noexcept {
    const double of_angles = angles_.sum() / (4.0 * kPi);
    return held_ == 0 ? WindingNumber{of_angles, kRounding, visits_}
                      : WindingNumber{of_angles + of_moments_.value, of_moments_.error + kRounding,
                                      visits_};
  }

 private:
  using Held = MeshQueryMemory::NodePair;  // its bound is the error, not squared
  static constexpr std::size_t kMostHeld = MeshFront::kCapacity;  // the rest is the stack

  BoundedNumber momentsAt(std::uint32_t node) const noexcept {
    return windingOf(tree_.openSurface()->moments[node], point_);
  }

  void open(std::uint32_t node, double most_of_part) noexcept {
    ++visits_;
    const BoundedNumber part = momentsAt(node);
    if (!(part.error <= most_of_part) || held_ == kMostHeld) {
      openChildren(node, most_of_part);
      return;
    }
    of_moments_.value += part.value;
    of_moments_.error += part.error;
    memory_.node_pairs[held_++] = {static_cast<float>(part.error), node, 0};
  }

  void openChildren(std::uint32_t node, double most_of_part) noexcept;

  const MeshTree& tree_;
  const Eigen::Vector3d& point_;
  MeshQueryMemory& memory_;
  SolidAngles angles_;
  BoundedNumber of_moments_;
  std::size_t held_{0};  // parts that count by their moments
  std::uint32_t visits_{0};
};

// Recursion is as deep as the tree.
void SumOfParts::openChildren(std::uint32_t node, double most_of_part) noexcept {
  for (const std::uint32_t child : tree_.nodes()[node].child) {
    if (child == kNone) {
      continue;
    }
    if (isTriangle(child)) {
      angles_.add(tree_.triangles()[triangleAt(child)]);
      ++visits_;
    } else {
      open(child, most_of_part);
    }
  }
}

// Searches from coarse to fine.
template <class ReachesCutoff>
WindingNumber search(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory,
                     const ReachesCutoff& reachesCutoff) noexcept {
  constexpr double kCoarsest = 0x1p-6;
  constexpr double kStep = 0x1p-3;
  double most_of_part = kCoarsest;
  SumOfParts sum(tree, point, memory);
  sum.openRoot(most_of_part);
  WindingNumber number = sum.number();
  while (number.error > kRounding && !reachesCutoff(number)) {
    most_of_part *= kStep;
    sum.openCoarse(most_of_part);
    number = sum.number();
  }
  return number;
}

}  // namespace

WindingNumber windingNumber(const MeshTree& tree, const Eigen::Vector3d& point, double error,
                            MeshQueryMemory& memory) noexcept {
  return search(tree, point, memory,
                [&](const WindingNumber& number) { return number.error <= error; });
}

WindingNumber windingByLimit(const MeshTree& tree, const Eigen::Vector3d& point, double limit,
                             double error, MeshQueryMemory& memory, double share) noexcept {
  return search(tree, point, memory, [&](const WindingNumber& number) {
    const double below = limit - std::abs(number.value);
    return number.error <= error || (below > 0.0 ? share * below : -below) > number.error;
  });
}

}  // namespace collision_monitor
