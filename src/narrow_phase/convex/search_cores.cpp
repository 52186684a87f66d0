// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/search_cores.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/convex/search_round.h"
#include "narrow_phase/epa/epa.h"
#include "narrow_phase/epa/round_depth.h"
#include "narrow_phase/gjk/distance_parallel_axes.h"
#include "narrow_phase/gjk/flat_contact.h"
#include "narrow_phase/gjk/gjk.h"
#include "narrow_phase/sat/hull_depth.h"
#include "narrow_phase/warm_start/depth_from_warm_start.h"

namespace collision_monitor {
namespace {

// [m] Bounds that differ by less than this are equal: the error that convex_distance.h promises,
// and for larger sizes what doubles leave of it.
double promiseApart(const ConvexPair& pair) noexcept { return 1e-9 + 1e-11 * pair.size; }

ConvexDistance answer(double distance, const Eigen::Vector3d& normal,
                      const Eigen::Vector3d& point_on_a, Quality quality) noexcept {
  return {{distance, point_on_a, point_on_a + distance * normal, normal}, quality};
}

ConvexDistance answerApart(const ConvexPair& pair, const GjkResult& found) noexcept {
  const Simplex& simplex = found.simplex;
  const double promise = promiseApart(pair);
  if (simplex.distance - found.lower <= promise) {
    // On curved surfaces the best plane's normal and the points may differ by half the digits.
    const bool is_proven = pair.isSmooth() && simplex.distance - found.gap <= 0.5 * promise;
    return answer(simplex.distance, is_proven ? simplex.normal : found.lower_direction,
                  simplex.pointOnA(), Quality::exact);
  }
  return answer(found.lower, found.lower_direction, simplex.pointOnA(), Quality::lower_bound);
}

// [m] On a curved surface a step of EPA cuts the sag of a face to a quarter, so every digit has its
// price.
double toleranceOfDepth(const ConvexPair& pair, const ConvexSearch& search) noexcept {
  constexpr double kAlone = 5e-8;
  const double fine = 1e-10 * pair.size;
  return !pair.isSmooth()      ? roundingOf(pair)
         : search.stands_alone ? std::max(fine, std::min(kAlone, 100.0 * fine))
                               : fine;
}

ConvexDistance answerOverlap(ConvexPair& pair, const GjkResult& found,
                             ConvexSearch& search) noexcept {
  const Penetration deep =
      runEpa(pair, found.simplex, toleranceOfDepth(pair, search), search.workspace);
  if (deep.face_size > 0) {
    keepWarm(deep.face.data(), deep.face_size, pair, search.warm);
    if (deep.is_settled && !pair.isSmooth()) {
      cachePolytope(search.workspace, search.warm);
    }
  }
  ConvexDistance closed{SignedDistance{}, Quality::exact};
  if (!deep.is_settled && depthOfRound(pair, 0.5 * deep.at_least, closed.measured)) {
    return closed;  // at_least is halved: the polytope may have skipped slivers
  }
  // GJK's points of touching cores touch. The points of EPA's faces, all equally shallow, may not.
  const bool touch = found.state == GjkResult::State::overlapping &&
                     !found.simplex.contains_origin &&
                     std::abs(deep.depth) <= 2.0 * touchingDistance(pair);
  return answer(-deep.depth, -deep.outward, touch ? found.simplex.pointOnA() : deep.on_a,
                deep.is_settled ? Quality::exact : Quality::lower_bound);
}

// The nearest face gives the depth. `point` is in the frame of the hull, which is B.
ConvexDistance pointInHull(const Eigen::Vector3d& point, const ConvexHull& hull) noexcept {
  double distance = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  for (const ConvexHull::Face& face : hull.faces()) {
    const double beyond = face.normal.dot(point) - face.offset;
    if (beyond > distance) {
      distance = beyond;
      normal = face.normal;
    }
  }
  return answer(distance, -normal, point, Quality::exact);
}

bool holdsPoint(const ConvexCore& hull, const ConvexCore& point) noexcept {
  return hull.kind == ConvexCore::Kind::hull && hull.hull->hasVolume() && isPoint(point);
}

// Runs GJK. If it finds an overlap, runs what settles the depth.
ConvexDistance searchApartOrDeep(ConvexPair& pair, ConvexSearch& search) noexcept {
  search.warm.polytope_faces = 0;
  GjkResult found;
  if (pair.isSmooth()) {
    ConvexDistance closest{SignedDistance{}, Quality::exact};
    if (searchRound(pair, search, found, closest.measured)) {
      return closest;
    }
  } else {
    found = runGjk(pair, search.warm, {search.cutoff});
  }
  keepWarm(found.simplex.vertices.data(), found.simplex.size, pair, search.warm);
  const bool is_apart =
      found.state != GjkResult::State::overlapping && found.lower > touchingDistance(pair);
  if (is_apart || found.state == GjkResult::State::settled) {
    if (isSmooth(pair.a) && isSmooth(pair.b)) {
      // The closest points tell rims from sides; the vertices of the last step do not.
      search.warm.size = 1;
      search.warm.ends[0] = {found.simplex.pointOnA(), found.simplex.pointOnB()};
    }
    return answerApart(pair, found);
  }
  ConvexDistance closed;
  if (holdsPoint(pair.b, pair.a)) {
    closed = pointInHull(inverse(pair.a_from_b).translation, *pair.b.hull);
    closed.measured = placed(pair.a_from_b, closed.measured);
    return closed;
  }
  if (holdsPoint(pair.a, pair.b)) {
    closed = pointInHull(pair.a_from_b.translation, *pair.a.hull);
    closed.measured = swapped(closed.measured);
    return closed;
  }
  return answerOverlap(pair, found, search);
}

// Measures hulls without a warm start by their axes. Leaves the vertices that face each other along
// the last axis: if the hulls are apart, GJK starts there.
bool depthByAxes(ConvexPair& pair, ConvexWarmStart& warm, SignedDistance& found) noexcept {
  if (warm.size > 0 || !haveFewFaces(pair)) {
    return false;
  }
  const Eigen::Vector3d& between = pair.a_from_b.translation;
  const SupportVertex facing = leastAlong(between, pair);
  if (between.dot(facing.difference) > 0.0) {
    keepWarm(&facing, 1, pair, warm);
    return false;
  }
  const bool is_deep = depthOfHulls(pair, found);
  const SupportVertex along_axis = differenceOf(pair, pair.a.hull->vertices()[pair.vertex_of_a],
                                                pair.b.hull->vertices()[pair.vertex_of_b]);
  keepWarm(&along_axis, 1, pair, warm);
  return is_deep;
}

}  // namespace

ConvexDistance searchCores(ConvexPair& pair, ConvexSearch& search) noexcept {
  // A bound up to the touching distance does not tell cores apart.
  search.cutoff = std::max(search.cutoff, 2.0 * touchingDistance(pair));
  ConvexDistance found{SignedDistance{}, Quality::exact};
  if (distanceOfParallelAxes(pair, found.measured)) {
    return found;
  }
  if (depthByAxes(pair, search.warm, found.measured)) {
    return found;
  }
  found = searchApartOrDeep(pair, search);
  if (found.quality == Quality::exact && !search.stands_alone) {
    const Pose origin;
    centerOnPatch({pair.a, origin, pair.vertex_of_a}, {pair.b, pair.a_from_b, pair.vertex_of_b},
                  found.measured);
  }
  return found;
}

}  // namespace collision_monitor
