// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <type_traits>

#include "collision_monitor/geometry/visit_held.h"
#include "collision_monitor/narrow_phase/convex_pairs.h"
#include "narrow_phase/convex/convex_core.h"
#include "narrow_phase/convex/flat_contact.h"
#include "narrow_phase/convex/proof_rows.h"
#include "narrow_phase/convex/support_plane.h"
#include "narrow_phase/core_distance.h"

namespace collision_monitor {
namespace {

// Rows by how many corners, less one, the last search of their pairs ended at: that decides which
// way a proof takes, so that rows of one kind take the same.
using RowsByCorners = std::array<ProofRows, 3>;

struct Work {
  const ConvexQuery* queries;
  ConvexWorkspace& workspace;
  ConvexDistance* answers;
};

void measureAlone(std::size_t i, const Work& work) noexcept {
  const ConvexQuery& query = work.queries[i];
  ConvexSearch search{work.workspace, *query.warm};
  work.answers[i] =
      signedDistanceBetween(*query.a, *query.world_from_a, *query.b, *query.world_from_b, search);
}

// Returns false for what has no corners, or no fans to look at.
bool fillSide(const ConvexGeometry& geometry, const Pose& world_from_core, std::uint32_t vertex,
              ProofSide& side, double& reach) noexcept {
  side.world_from_core = world_from_core.rotation.data();
  side.vertex = vertex;
  if (const auto* hull = std::get_if<ConvexHull>(&geometry)) {
    side.hull = hull;
    side.radius = 0.0;
    reach = hull->boundingRadius();
    return hull->canClimb();
  }
  const auto fill = [&](const auto& held) noexcept {
    if constexpr (std::is_same_v<decltype(held), const HalfSpace&>) {
      return false;
    } else {
      const auto [core, radius] = sweptCoreOf(held);
      const Eigen::Vector3d& half = core.half_extents;
      side.hull = nullptr;
      side.half_extents = {half.x(), half.y(), half.z()};
      side.radius = radius;
      reach = reachOf(core);
      return !isSmooth(core);
    }
  };
  return visitHeld(fill, geometry);
}

bool isHull(const ConvexGeometry& geometry) noexcept {
  return std::holds_alternative<ConvexHull>(geometry);
}

// Returns false for pairs that are measured in another way.
bool fillRow(const ConvexQuery& query, ProofRows& rows) noexcept {
  const std::size_t row = rows.count;
  double reach_of_a = 0.0;
  double reach_of_b = 0.0;
  if (!(isHull(*query.a) || isHull(*query.b)) ||
      !fillSide(*query.a, *query.world_from_a, query.warm->vertex_of_a, rows.a[row], reach_of_a) ||
      !fillSide(*query.b, *query.world_from_b, query.warm->vertex_of_b, rows.b[row], reach_of_b)) {
    return false;
  }
  rows.at[proof::size][row] = reach_of_a + reach_of_b;
  rows.ends[row] = query.warm->ends[0].on_a.data();
  return true;
}

ConvexCore coreOf(const ProofSide& side) noexcept {
  ConvexCore core;
  if (side.hull != nullptr) {
    core.kind = ConvexCore::Kind::hull;
    core.hull = side.hull;
  } else {
    core.half_extents << side.half_extents[0], side.half_extents[1], side.half_extents[2];
  }
  return core;
}

// As swept() of the answer of the cores, number by number: vectors would be read in pairs where
// they were just written one by one.
void writeAnswer(std::size_t row, const ProofRows& rows, SignedDistance& measured) noexcept {
  const double distance = rows.at[proof::distance][row];
  const double radius_a = rows.a[row].radius;
  const double radius_b = rows.b[row].radius;
  measured.distance = distance - radius_a - radius_b;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double on_a = rows.at[proof::point_on_a + k][row];
    const double normal = rows.at[proof::normal + k][row];
    measured.point_on_a[i] = on_a + radius_a * normal;
    measured.point_on_b[i] = on_a + distance * normal - radius_b * normal;
    measured.normal_a_to_b[i] = normal;
  }
}

// Moves the points of level features over the middle of what they share.
void centerRow(const ConvexQuery& query, std::size_t row, ProofRows& rows,
               SignedDistance& measured) noexcept {
  ProofSide& a = rows.a[row];
  ProofSide& b = rows.b[row];
  const ConvexCore core_a = coreOf(a);
  const ConvexCore core_b = coreOf(b);
  const PlacedCore placed_a{core_a, *query.world_from_a, a.vertex};
  const PlacedCore placed_b{core_b, *query.world_from_b, b.vertex};
  const auto& normal = measured.normal_a_to_b;
  if (areLevel(makePlacedPair(placed_a, placed_b), {normal, 0.0, true})) {
    const auto& at = rows.at;
    const Eigen::Vector3d on_a(at[proof::point_on_a][row], at[proof::point_on_a + 1][row],
                               at[proof::point_on_a + 2][row]);
    const double distance = at[proof::distance][row];
    SignedDistance cores{distance, on_a, on_a + distance * normal, normal};
    centerOnPatch(placed_a, placed_b, cores);
    measured = swept(cores, a.radius, b.radius);
  }
}

void answerRow(std::size_t row, ProofRows& rows, const Work& work) noexcept {
  const std::size_t i = rows.query[row];
  const ConvexQuery& query = work.queries[i];
  if (std::isnan(rows.at[proof::distance][row])) {
    measureAlone(i, work);
    return;
  }
  SignedDistance& measured = work.answers[i].measured;
  writeAnswer(row, rows, measured);
  if (rows.may_be_level[row]) {
    centerRow(query, row, rows, measured);
  }
  query.warm->vertex_of_a = rows.a[row].vertex;
  query.warm->vertex_of_b = rows.b[row].vertex;
  work.answers[i].quality = DistanceQuality::exact;
}

void answerRows(std::size_t corners, ProofRows& rows, const Work& work) noexcept {
  if (rows.count == 0) {
    return;
  }
  proveRows(corners, rows);
  for (std::size_t row = 0; row < rows.count; ++row) {
    answerRow(row, rows, work);
  }
  rows.count = 0;
}

}  // namespace

void signedDistancesBetween(const ConvexQuery* queries, std::size_t count,
                            ConvexWorkspace& workspace, ConvexDistance* answers) noexcept {
  const Work work{queries, workspace, answers};
  RowsByCorners by_corners;
  for (ProofRows& rows : by_corners) {
    rows.count = 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t corners = queries[i].warm->size;
    const bool overlapped = queries[i].warm->inside_faces > 0;
    if (corners == 0 || corners > by_corners.size() || overlapped ||
        !fillRow(queries[i], by_corners[corners - 1])) {
      measureAlone(i, work);
      continue;
    }
    ProofRows& rows = by_corners[corners - 1];
    rows.query[rows.count++] = i;
    if (rows.count == kProofRows) {
      answerRows(corners, rows, work);
    }
  }
  for (std::size_t corners = 1; corners <= by_corners.size(); ++corners) {
    answerRows(corners, by_corners[corners - 1], work);
  }
}

}  // namespace collision_monitor
