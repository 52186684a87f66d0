// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_bounds.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3f;
using LanesOfNode = Eigen::Map<const Lanes, Eigen::Aligned32>;

// Directions, one for each child, in which bounds are held against each other.
struct Directions {
  Lanes along[3];

  Lanes dot(const Vector3f& v) const noexcept {
    return along[0] * v[0] + along[1] * v[1] + along[2] * v[2];
  }
};

// What a bound covers along a direction.
struct Shadow {
  Lanes middle;
  Lanes half;
};

// A direction u is split as u = c n + w, n the normal of the slab: the slab bounds c n.x and the
// box bounds w.x. For directions near the normal w is small, and the shadow is as thin as the slab.
Shadow shadowOfOther(const PlacedBound& other, const Directions& u, const Lanes& shared) noexcept {
  const Directions rest{{u.along[0] - shared * other.normal[0],
                         u.along[1] - shared * other.normal[1],
                         u.along[2] - shared * other.normal[2]}};
  return {shared * other.slab_center + rest.dot(other.center),
          shared.abs() * other.slab_half + rest.dot(other.sides.col(0)).abs() +
              rest.dot(other.sides.col(1)).abs() + rest.dot(other.sides.col(2)).abs()};
}

Shadow shadowOfChildren(const MeshTreeNode& node, const Directions& u,
                        const Lanes& shared) noexcept {
  Shadow shadow{shared * LanesOfNode(node.slab_center), shared.abs() * LanesOfNode(node.slab_half)};
  for (int k = 0; k < 3; ++k) {
    const Lanes rest = u.along[k] - shared * LanesOfNode(node.normal[k]);
    shadow.middle += rest * LanesOfNode(node.center[k]);
    shadow.half += rest.abs() * LanesOfNode(node.half[k]);
  }
  return shadow;
}

Lanes gapBetween(const Shadow& a, const Shadow& b) noexcept {
  return (a.middle - b.middle).abs() - (a.half + b.half);
}

// Along the children's normals, of which they know their extent.
Lanes gapAlongChildren(const MeshTreeNode& node, const Directions& normals, const Lanes& shared,
                       const PlacedBound& other) noexcept {
  return gapBetween(shadowOfOther(other, normals, shared),
                    {LanesOfNode(node.slab_center), LanesOfNode(node.slab_half)});
}

Lanes gapAlongOther(const MeshTreeNode& node, const Lanes& shared,
                    const PlacedBound& other) noexcept {
  const Directions normal{{Lanes::Constant(other.normal[0]), Lanes::Constant(other.normal[1]),
                           Lanes::Constant(other.normal[2])}};
  return gapBetween(shadowOfChildren(node, normal, shared),
                    {Lanes::Constant(other.slab_center), Lanes::Constant(other.slab_half)});
}

// Along the line of centres, which far bounds are apart by.
Lanes gapAlongCenters(const MeshTreeNode& node, const Directions& normals,
                      const PlacedBound& other) noexcept {
  Directions u;
  Lanes squared = Lanes::Constant(1e-30F);
  for (int k = 0; k < 3; ++k) {
    u.along[k] = other.center[k] - LanesOfNode(node.center[k]);
    squared += u.along[k].square();
  }
  // A little less than unit, so that no gap comes out too large.
  const Lanes shorten = (1.0F - 1e-6F) / squared.sqrt();
  Lanes shared_with_children = Lanes::Zero();
  for (int k = 0; k < 3; ++k) {
    u.along[k] *= shorten;
    shared_with_children += u.along[k] * normals.along[k];
  }
  return gapBetween(shadowOfOther(other, u, u.dot(other.normal)),
                    shadowOfChildren(node, u, shared_with_children));
}

}  // namespace

BoundPlacement makePlacement(const Pose& a_from_b, double size) noexcept {
  constexpr double kSlack = 1.0 / (1 << 17);  // 128 u
  return {a_from_b.rotation.cast<float>(), a_from_b.translation.cast<float>(),
          static_cast<float>(kSlack * size)};
}

Bound boundOf(const MeshTreeNode& node, std::uint32_t slot) noexcept {
  return {{node.center[0][slot], node.center[1][slot], node.center[2][slot]},
          {node.half[0][slot], node.half[1][slot], node.half[2][slot]},
          {node.normal[0][slot], node.normal[1][slot], node.normal[2][slot]},
          node.slab_center[slot],
          node.slab_half[slot]};
}

PlacedBound place(const BoundPlacement& placement, const Bound& bound) noexcept {
  PlacedBound placed;
  placed.center = placement.rotation * bound.center + placement.translation;
  placed.sides = placement.rotation * bound.half.asDiagonal();
  placed.reach = placed.sides.cwiseAbs().rowwise().sum().array() + placement.slack;
  placed.normal = placement.rotation * bound.normal;
  placed.slab_center = bound.slab_center + placed.normal.dot(placement.translation);
  placed.slab_half = bound.slab_half + placement.slack;
  placed.slack = 2.0F * placement.slack;
  return placed;
}

void squaredLowerBounds(const MeshTreeNode& node, const PlacedBound& other, Lanes& squared,
                        Lanes& order) noexcept {
  Directions normals;
  Lanes shared = Lanes::Zero();
  squared.setZero();
  for (int k = 0; k < 3; ++k) {
    const Lanes gap = (LanesOfNode(node.center[k]) - other.center[k]).abs() -
                      (LanesOfNode(node.half[k]) + other.reach[k]);
    squared += gap.max(0.0F).square();
    normals.along[k] = LanesOfNode(node.normal[k]);
    shared += normals.along[k] * other.normal[k];
  }
  order = gapAlongCenters(node, normals, other);
  const Lanes gap = gapAlongChildren(node, normals, shared, other)
                        .max(gapAlongOther(node, shared, other))
                        .max(order - other.slack)
                        .max(0.0F);
  squared = squared.max(gap.square());
}

}  // namespace collision_monitor
