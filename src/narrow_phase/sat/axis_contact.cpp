// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/axis_contact.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/contact/patch.h"

namespace collision_monitor {
namespace {

// The feature of B that is extreme against `normal`. B's axes that are perpendicular to the normal
// span it.
struct Feature {
  Eigen::Vector3d center;
  Eigen::Vector3d sides[2];
  int side_count{0};
};

Feature extremeFeatureOfB(const BoxPair& pair, const Eigen::Vector3d& normal) noexcept {
  Feature feature;
  feature.center = pair.center_of_b;
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Eigen::Vector3d side = pair.half_b[j] * pair.a_from_b.col(j);
    const double slope = normal.dot(pair.a_from_b.col(j));
    if (std::abs(slope) > kParallel) {
      feature.center -= signOf(slope) * side;
    } else if (pair.half_b[j] > 0.0 && feature.side_count < 2) {
      feature.sides[feature.side_count++] = side;
    }
  }
  return feature;
}

// A possible contact. `defect` is how far its points are off their features. Always satisfies
// point_on_b - point_on_a = distance * normal.
struct Candidate {
  SignedDistance cores;
  double defect{std::numeric_limits<double>::infinity()};
};

Candidate contactOnFaceOfA(const BoxPair& pair, Eigen::Index axis, double separation,
                           double slack) noexcept {
  const Eigen::Index p = (axis + 1) % 3;
  const Eigen::Index q = (axis + 2) % 3;
  const double side = signOf(pair.center_of_b[axis]);
  const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
  const Feature feature = extremeFeatureOfB(pair, normal);
  FlatFeature flat;
  flat.center = {feature.center[p], feature.center[q]};
  flat.side_count = feature.side_count;
  for (int i = 0; i < feature.side_count; ++i) {
    flat.sides[i] = {feature.sides[i][p], feature.sides[i][q]};
  }
  const Eigen::Vector2d half_extents(pair.half_a[p], pair.half_a[q]);
  Eigen::Vector2d center = flat.center;
  Candidate candidate;
  candidate.defect = 0.0;
  if (!patchCenter(flat, half_extents, slack, center)) {
    center = flat.center.cwiseMax(-half_extents).cwiseMin(half_extents);
    candidate.defect = (flat.center - center).norm();
  }
  candidate.cores.distance = separation;
  candidate.cores.normal_a_to_b = normal;
  candidate.cores.point_on_a[axis] = side * pair.half_a[axis];
  candidate.cores.point_on_a[p] = center.x();
  candidate.cores.point_on_a[q] = center.y();
  candidate.cores.point_on_b = candidate.cores.point_on_a + separation * normal;
  return candidate;
}

Candidate contactOnFaceOfB(const BoxPair& pair, Eigen::Index axis, double separation,
                           double slack) noexcept {
  Candidate candidate = contactOnFaceOfA(swapped(pair), axis, separation, slack);
  candidate.cores = swapped(placed(aFromB(pair), candidate.cores));
  return candidate;
}

Candidate contactOfEdges(const BoxPair& pair, std::size_t axis, double separation) noexcept {
  const auto i = static_cast<Eigen::Index>(axis - kFirstEdgePair) / 3;
  const auto j = static_cast<Eigen::Index>(axis - kFirstEdgePair) % 3;
  const Eigen::Vector3d normal = axisDirection(pair, axis);
  Segment edge_of_a{Eigen::Vector3d::Zero(), Eigen::Vector3d::Unit(i), pair.half_a[i]};
  Segment edge_of_b{pair.center_of_b, pair.a_from_b.col(j), pair.half_b[j]};
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (k != i) {
      edge_of_a.center[k] = signOf(normal[k]) * pair.half_a[k];
    }
    if (k != j) {
      const Eigen::Vector3d axis_of_b = pair.a_from_b.col(k);
      edge_of_b.center -= signOf(normal.dot(axis_of_b)) * pair.half_b[k] * axis_of_b;
    }
  }
  const ClosestParameters closest = closestParameters(edge_of_a, edge_of_b);
  Candidate candidate;
  candidate.cores.distance = separation;
  candidate.cores.normal_a_to_b = normal;
  candidate.cores.point_on_a = edge_of_a.at(closest.on_a);
  candidate.cores.point_on_b = candidate.cores.point_on_a + separation * normal;
  candidate.defect = (candidate.cores.point_on_b - edge_of_b.at(closest.on_b)).norm();
  return candidate;
}

Candidate contactOnAxis(const BoxPair& pair, std::size_t axis, double separation,
                        double slack) noexcept {
  if (axis < kFirstFaceOfB) {
    return contactOnFaceOfA(pair, static_cast<Eigen::Index>(axis), separation, slack);
  }
  if (axis < kFirstEdgePair) {
    return contactOnFaceOfB(pair, static_cast<Eigen::Index>(axis - kFirstFaceOfB), separation,
                            slack);
  }
  return contactOfEdges(pair, axis, separation);
}

// The first axis that ties for the largest separation within `tie` and has its points on their
// features within `slack`; else the axis with the least defect.
Candidate bestContact(const BoxPair& pair, const Separations& separations, double tie,
                      double slack) noexcept {
  const double least = separations.largest - tie;
  Candidate best;
  for (std::size_t axis = 0; axis < kAxisCount && best.defect > slack; ++axis) {
    if (separations.along[axis] >= least) {
      const Candidate candidate = contactOnAxis(pair, axis, separations.along[axis], slack);
      best = candidate.defect < best.defect ? candidate : best;
    }
  }
  return best;
}

// How far B's axes are from unit length and right angles.
double skewOf(const BoxPair& pair) noexcept {
  const Eigen::Matrix3d products = pair.a_from_b.transpose() * pair.a_from_b;
  return (products - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

}  // namespace

bool contactAlongAxis(const BoxPair& pair, const Separations& separations,
                      SignedDistance& cores) noexcept {
  constexpr double kNoSkew = 1e-15;  // of one rotation, by rounding
  double slack = toleranceOf(pair);
  Candidate best = bestContact(pair, separations, slack, slack);
  if (best.defect > slack) {
    const double skew = skewOf(pair);
    if (skew > kNoSkew) {
      slack += 2.0 * skew * lengthsOf(pair);
      best = bestContact(pair, separations, slack, slack);
    }
  }
  cores = best.cores;
  return best.defect <= slack;
}

SignedDistance nearestContact(const BoxPair& pair, const Separations& separations) noexcept {
  // Touching corners may be kTouching apart along each axis, so that no face holds a point.
  const double tie = toleranceOf(pair);
  return bestContact(pair, separations, tie, tie + 2.0 * kTouching).cores;
}

}  // namespace collision_monitor
