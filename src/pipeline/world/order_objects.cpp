// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/order_objects.h"

#include <algorithm>

#include "broad_phase/tree_nodes.h"

namespace collision_monitor {
namespace {

using Objects = std::vector<const WorldObject*>::iterator;

const Eigen::Vector3d& placeOf(const WorldObject* object) noexcept {
  return object->frame_from_object.translation;
}

/// How far the objects spread along each axis. Units: metres.
Eigen::Vector3d spreadOf(Objects first, Objects last) {
  Eigen::Vector3d least = placeOf(*first);
  Eigen::Vector3d most = least;
  for (; first != last; ++first) {
    least = least.cwiseMin(placeOf(*first));
    most = most.cwiseMax(placeOf(*first));
  }
  return most - least;
}

/// Splits the objects in halves along the axis in which they spread most, and these again. Halves
/// hold whole nodes of a RigidTree of each level.
void split(Objects first, Objects last) {
  const auto count = static_cast<std::size_t>(last - first);
  const Eigen::Vector3d spread = spreadOf(first, last);
  Eigen::Index axis = 0;
  if (count <= kTreeChildren || !(spread.maxCoeff(&axis) > 0.0)) {
    return;
  }
  std::size_t node = kTreeChildren;  // the largest that does not hold all
  while (node * kTreeChildren < count) {
    node *= kTreeChildren;
  }
  const std::size_t half = node * ((count / node + 1) / 2);
  const auto middle = first + static_cast<std::ptrdiff_t>(half);
  std::nth_element(first, middle, last, [&](const WorldObject* one, const WorldObject* other) {
    return placeOf(one)[axis] < placeOf(other)[axis];
  });
  split(first, middle);
  split(middle, last);
}

}  // namespace

void orderByPlace(std::vector<const WorldObject*>& objects) {
  constexpr std::size_t kMany = 64;
  if (objects.size() >= kMany) {
    split(objects.begin(), objects.end());
  }
}

}  // namespace collision_monitor
