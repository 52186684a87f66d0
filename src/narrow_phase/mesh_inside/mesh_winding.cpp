// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_inside/mesh_winding.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_inside/mesh_crossings.h"

namespace collision_monitor {
namespace {

// Rounding of a sum of up to 1e7 solid angles.
constexpr double kRounding = 1e-9;

// What a float of an error is off by, and more.
constexpr double kUp = 1.0 + 1e-6;

// Work of what a line of sight looks at.
constexpr std::uint32_t kPartsPerCrossing = 2;

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
        of_moments_ -= momentsAt(part.a).value;
        openChildren(part.a, most_of_part);
      }
    }
  }

  WindingNumber number() noexcept {
    double error = kRounding;
    for (std::size_t i = 0; i < held_; ++i) {
      error += static_cast<double>(memory_.node_pairs[i].squared_bound);
    }
    return {angles_.sum() / (4.0 * kPi) + of_moments_, error, parts_};
  }

 private:
  using Held = MeshQueryMemory::NodePair;  // its bound is the error, not squared
  static constexpr std::size_t kMostHeld = MeshFront::kCapacity;  // the rest is the stack

  BoundedNumber momentsAt(std::uint32_t node) const noexcept {
    return windingOf(tree_.openSurface()->moments[node], point_);
  }

  void open(std::uint32_t node, double most_of_part) noexcept {
    ++parts_;
    const BoundedNumber part = momentsAt(node);
    if (!(part.error <= most_of_part) || held_ == kMostHeld) {
      openChildren(node, most_of_part);
      return;
    }
    of_moments_ += part.value;
    memory_.node_pairs[held_++] = {static_cast<float>(kUp * part.error), node, 0};
  }

  void openChildren(std::uint32_t node, double most_of_part) noexcept;

  const MeshTree& tree_;
  const Eigen::Vector3d& point_;
  MeshQueryMemory& memory_;
  SolidAngles angles_;
  double of_moments_{0.0};
  std::size_t held_{0};  // parts that count by their moments
  std::uint32_t parts_{0};
};

// Recursion is as deep as the tree.
void SumOfParts::openChildren(std::uint32_t node, double most_of_part) noexcept {
  for (const std::uint32_t child : tree_.nodes()[node].child) {
    if (child == kNone) {
      continue;
    }
    if (isTriangle(child)) {
      angles_.add(tree_.triangles()[triangleAt(child)]);
      ++parts_;
    } else {
      open(child, most_of_part);
    }
  }
}

// Directions of sight that no edge of a model is likely to have: x and y for 1 of z. A round rim
// brings points into the walls of three directions at once, but not of five.
const std::array<Eigen::Vector2d, 5> kSlopes = {
    Eigen::Vector2d(0.271828, 0.141421), Eigen::Vector2d(-0.173205, 0.223607),
    Eigen::Vector2d(0.316228, -0.264575), Eigen::Vector2d(-0.618034, -0.414214),
    Eigen::Vector2d(0.057721, 0.693147)};

WindingNumber sumOfTriangles(const MeshTree& tree, const Eigen::Vector3d& point) noexcept {
  SolidAngles angles(point);
  for (const Triangle& triangle : tree.triangles()) {
    angles.add(triangle);
  }
  return {angles.sum() / (4.0 * kPi), kRounding,
          static_cast<std::uint32_t>(tree.triangles().size())};
}

// Walls from the rim, away from the line of sight, close the surface, and the line meets none of
// them. So the crossings of the surface are the winding number of both together. Where a point is
// in a wall, another direction is taken, and at last the sum of all triangles.
WindingNumber windingByRim(const MeshTree& tree, const Eigen::Vector3d& point,
                           MeshQueryMemory& memory) noexcept {
  const SurfaceRim& rim = tree.openSurface()->rim;
  std::uint32_t parts = 0;
  for (const Eigen::Vector2d& slope : kSlopes) {
    const Eigen::Vector3d sight = slope.homogeneous().normalized();
    const RimWalls walls = wallsSeenFrom(point, -sight, rim);
    parts += static_cast<std::uint32_t>(kPartsPerBlock * rim.blocks().size());
    if (walls.is_certain) {
      const Crossings above = crossingsAbove(tree, point, slope, memory);
      return {above.turns + walls.angle / (4.0 * kPi), kRounding,
              parts + kPartsPerCrossing * above.visits};
    }
  }
  WindingNumber number = sumOfTriangles(tree, point);
  number.parts += parts;
  return number;
}

// Searches from coarse to fine.
template <class ReachesCutoff>
WindingNumber search(const MeshTree& tree, const Eigen::Vector3d& point, MeshQueryMemory& memory,
                     const ReachesCutoff& reachesCutoff) noexcept {
  constexpr double kFarthest = 1e100;  // [m] beyond it products of lengths overflow
  if (!(point.cwiseAbs().array() <= kFarthest).all()) {
    return {0.0, kInfinity, 1};
  }
  if (tree.openSurface()->moments.empty()) {
    return windingByRim(tree, point, memory);
  }
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
