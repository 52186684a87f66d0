// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/cylinder_pairs.h"

#include <cmath>

#include "narrow_phase/warm_start/cylinder_from_warm_start.h"

namespace collision_monitor {
namespace {

using Ends = ConvexWarmStart::Ends;

// Null for other geometries, and for cylinders of radius 0, which are segments.
const Cylinder* roundOf(const ConvexGeometry& geometry) noexcept {
  const auto* cylinder = std::get_if<Cylinder>(&geometry);
  return cylinder != nullptr && cylinder->radius > 0.0 ? cylinder : nullptr;
}

// The cylinder of a pair and the other core, as castRoles() of cylinder_from_warm_start.cpp.
struct RowRoles {
  const Cylinder* cylinder;
  const Pose* world_from_cylinder;
  const ConvexGeometry* other;
  const Pose* world_from_other;
  bool is_swapped;
};

RowRoles rolesOf(const ConvexQuery& query, bool is_swapped) noexcept {
  if (is_swapped) {
    return {roundOf(*query.b), query.world_from_b, query.a, query.world_from_a, true};
  }
  return {roundOf(*query.a), query.world_from_a, query.b, query.world_from_b, false};
}

double reachOf(const Cylinder& cylinder) noexcept {
  return std::sqrt(cylinder.radius * cylinder.radius + cylinder.half_length * cylinder.half_length);
}

Eigen::Vector3d halfExtentsOf(const Cylinder& cylinder) noexcept {
  return {cylinder.radius, cylinder.radius, cylinder.half_length};
}

void fillCylinder(const RowRoles& roles, double reach_of_other, CylinderRows& rows) noexcept {
  const std::size_t row = rows.count;
  rows.cylinder[row].world_from_core = roles.world_from_cylinder->rotation.data();
  rows.is_swapped[row] = roles.is_swapped;
  rows.at[closest::size][row] = reachOf(*roles.cylinder) + reach_of_other;
  rows.at[closest::radius][row] = roles.cylinder->radius;
  rows.at[closest::half_length][row] = roles.cylinder->half_length;
}

void followEnds(const RowRoles& roles, const Ends& last, CylinderRows& rows) noexcept {
  rows.last_on_cylinder[rows.count] = (roles.is_swapped ? last.on_b : last.on_a).data();
  rows.last_on_other[rows.count] = (roles.is_swapped ? last.on_a : last.on_b).data();
}

// For two cylinders. Returns false if their sides were nearest.
bool fillRim(const ConvexQuery& query, CylinderRows& rows) noexcept {
  const Ends& last = query.warm->ends[0];
  const bool follows_b = isOnRim(last.on_b, halfExtentsOf(*roundOf(*query.b)));
  const RowRoles roles = rolesOf(query, !follows_b);
  const Cylinder& other = *roundOf(*roles.other);
  if (query.warm->size == 0 || query.warm->size > 3 ||
      !(follows_b || isOnRim(last.on_a, halfExtentsOf(other)))) {
    return false;
  }
  const std::size_t row = rows.count;
  fillCylinder(roles, reachOf(other), rows);
  followEnds(roles, last, rows);
  rows.other[row].world_from_core = roles.world_from_other->rotation.data();
  rows.other[row].radius = 0.0;
  rows.at[closest::radius_of_other][row] = other.radius;
  rows.at[closest::half_length_of_other][row] = other.half_length;
  return true;
}

// For a core with corners. Returns false for other cores.
bool fillClosest(const RowRoles& roles, const ConvexWarmStart& warm, CylinderRows& rows) noexcept {
  double reach_of_other = 0.0;
  const std::uint32_t vertex = roles.is_swapped ? warm.vertex_of_a : warm.vertex_of_b;
  if (!fillSide(*roles.other, *roles.world_from_other, vertex, rows.other[rows.count],
                reach_of_other)) {
    return false;
  }
  fillCylinder(roles, reach_of_other, rows);
  followEnds(roles, warm.ends[0], rows);
  return true;
}

}  // namespace

std::optional<FollowedFeature> fillCylinderRow(const ConvexQuery& query,
                                               RowsByFeature& rows) noexcept {
  const auto rowsOf = [&](FollowedFeature followed) -> CylinderRows& {
    return rows[static_cast<std::size_t>(followed)];
  };
  const ConvexWarmStart& warm = *query.warm;
  const bool a_is_round = roundOf(*query.a) != nullptr;
  const bool b_is_round = roundOf(*query.b) != nullptr;
  if (a_is_round && b_is_round) {
    const bool is_filled = fillRim(query, rowsOf(FollowedFeature::rim));
    return is_filled ? std::make_optional(FollowedFeature::rim) : std::nullopt;
  }
  if (!a_is_round && !b_is_round) {
    return std::nullopt;
  }
  const RowRoles roles = rolesOf(query, b_is_round);
  const bool is_point = std::holds_alternative<Sphere>(*roles.other);
  if (!is_point && (warm.size == 0 || warm.size > 2)) {
    return std::nullopt;
  }
  const auto followed =
      is_point || warm.size == 1 ? FollowedFeature::corner : FollowedFeature::edge;
  CylinderRows& of_feature = rowsOf(followed);
  if (!fillClosest(roles, warm, of_feature)) {
    return std::nullopt;
  }
  if (is_point) {
    of_feature.last_on_other[of_feature.count] = kOriginOfCore;
  }
  return followed;
}

// Works number by number: vectors would be read in pairs right after being written one by one.
void answerCylinderRow(FollowedFeature followed, std::size_t row, const CylinderRows& rows,
                       const ConvexQuery& query, ConvexDistance& answer) noexcept {
  const bool is_swapped = rows.is_swapped[row];
  const ProofSide& other = rows.other[row];
  ConvexWarmStart& warm = *query.warm;
  SignedDistance& measured = answer.measured;
  Eigen::Vector3d& on_cylinder = is_swapped ? measured.point_on_b : measured.point_on_a;
  Eigen::Vector3d& on_other = is_swapped ? measured.point_on_a : measured.point_on_b;
  const double distance = rows.at[closest::distance][row];
  const double sign = is_swapped ? -1.0 : 1.0;
  measured.distance = distance - other.radius;
  answer.quality = Quality::exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double point = rows.at[closest::point + k][row];
    const double normal = rows.at[closest::normal + k][row];
    on_cylinder[i] = point + 0.0 * normal;  // as inflated(): may change the sign of a zero
    on_other[i] = point + distance * normal - other.radius * normal;
    measured.normal_a_to_b[i] = sign * normal;
    for (std::size_t end = 0; end < warm.size; ++end) {
      (is_swapped ? warm.ends[end].on_b : warm.ends[end].on_a)[i] =
          rows.at[closest::on_cylinder + k][row];
    }
    if (followed == FollowedFeature::rim) {
      (is_swapped ? warm.ends[0].on_a : warm.ends[0].on_b)[i] = rows.at[closest::on_other + k][row];
    }
  }
  if (followed == FollowedFeature::rim) {
    warm.size = 1;
  } else {
    (is_swapped ? warm.vertex_of_a : warm.vertex_of_b) = other.vertex;
  }
}

}  // namespace collision_monitor
