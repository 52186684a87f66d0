// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/convex/convex_pairs.h"
#include "narrow_phase/convex/cylinder_pairs.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/gjk/flat_contact.h"
#include "narrow_phase/gjk/support_plane.h"
#include "narrow_phase/warm_start/proof_rows.h"

namespace collision_monitor {
namespace {

// Rows by the number of corners, less one, at which the last search of their pairs ended. That
// number decides the form of the proof, so all rows of one kind take the same.
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

bool isHull(const ConvexGeometry& geometry) noexcept {
  return std::holds_alternative<ConvexHull>(geometry);
}

bool isCylinder(const ConvexGeometry& geometry) noexcept {
  return std::holds_alternative<Cylinder>(geometry);
}

bool isBox(const ConvexGeometry& geometry) noexcept {
  return std::holds_alternative<Box>(geometry) || std::holds_alternative<RoundedBox>(geometry);
}

// Returns false for pairs that rows do not measure.
bool fillRow(const ConvexQuery& query, ProofRows& rows) noexcept {
  const std::size_t row = rows.count;
  double reach_of_a = 0.0;
  double reach_of_b = 0.0;
  const bool are_proven =
      isHull(*query.a) || isHull(*query.b) || (isBox(*query.a) && isBox(*query.b));
  if (!are_proven ||
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

// Does what inflated() does to the cores' answer, number by number: vectors would be read in pairs
// right after being written one by one.
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

// Moves the points of level features over the middle of their common part.
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
    measured = inflated(cores, a.radius, b.radius);
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
  work.answers[i].quality = Quality::exact;
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

void answerRows(FollowedFeature followed, CylinderRows& rows, const Work& work) noexcept {
  if (rows.count == 0) {
    return;
  }
  proveCylinderRows(followed, rows);
  for (std::size_t row = 0; row < rows.count; ++row) {
    const std::size_t i = rows.query[row];
    if (std::isnan(rows.at[closest::distance][row])) {
      measureAlone(i, work);
    } else {
      answerCylinderRow(followed, row, rows, work.queries[i], work.answers[i]);
    }
  }
  rows.count = 0;
}

// Counts the filled row. Answers the rows once they are full.
template <class Kind, class Rows>
void takeRow(std::size_t i, Kind kind, Rows& rows, const Work& work) noexcept {
  rows.query[rows.count++] = i;
  if (rows.count == kProofRows) {
    answerRows(kind, rows, work);
  }
}

struct AllRows {
  RowsByCorners by_corners;
  RowsByFeature by_feature;
};

void measure(std::size_t i, AllRows& rows, const Work& work) noexcept {
  const ConvexQuery& query = work.queries[i];
  if (isCylinder(*query.a) || isCylinder(*query.b)) {
    if (const auto followed = fillCylinderRow(query, rows.by_feature)) {
      takeRow(i, *followed, rows.by_feature[static_cast<std::size_t>(*followed)], work);
      return;
    }
  }
  const std::size_t corners = query.warm->size;
  const bool overlapped = query.warm->polytope_faces > 0;
  if (corners == 0 || corners > rows.by_corners.size() || overlapped ||
      !fillRow(query, rows.by_corners[corners - 1])) {
    measureAlone(i, work);
    return;
  }
  takeRow(i, corners, rows.by_corners[corners - 1], work);
}

}  // namespace

void signedDistancesBetween(const ConvexQuery* queries, std::size_t count,
                            ConvexWorkspace& workspace, ConvexDistance* answers) noexcept {
  const Work work{queries, workspace, answers};
  AllRows rows;
  for (ProofRows& of_corners : rows.by_corners) {
    of_corners.count = 0;
  }
  for (CylinderRows& of_feature : rows.by_feature) {
    of_feature.count = 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    measure(i, rows, work);
  }
  for (std::size_t corners = 1; corners <= rows.by_corners.size(); ++corners) {
    answerRows(corners, rows.by_corners[corners - 1], work);
  }
  for (const auto followed :
       {FollowedFeature::corner, FollowedFeature::edge, FollowedFeature::rim}) {
    answerRows(followed, rows.by_feature[static_cast<std::size_t>(followed)], work);
  }
}

}  // namespace collision_monitor
