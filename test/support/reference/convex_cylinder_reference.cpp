// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "support/reference/convex_polyhedron.h"

// A cylinder and a polyhedron have few kinds of contact. A search in one dimension finds each.
// Apart: a corner, an edge or a face of the polyhedron is nearest to the cylinder. Overlapping: the
// least translation is along a face normal, along the axis, across the axis, or across an edge. For
// two cylinders all directions are searched.
namespace collision_monitor::test {
namespace {

constexpr Real kUnbounded = std::numeric_limits<Real>::infinity();

struct Peak {
  Real value{-kUnbounded};
  Real at{0};

  void offer(Real candidate, Real where) {
    if (candidate > value) {
      value = candidate;
      at = where;
    }
  }
};

// The largest value of `f` on [low, high]: samples, then golden sections around those that are no
// lower than their neighbours.
template <class Function>
Peak largestOn(Real low, Real high, int samples, const Function& f) {
  constexpr Real kGolden = 0.6180339887498948482L;
  const Real step = (high - low) / samples;
  const auto value_at = [&](int i) { return f(low + std::max(0, std::min(samples, i)) * step); };
  Peak peak;
  for (int i = 0; i <= samples; ++i) {
    const Real value = value_at(i);
    peak.offer(value, low + i * step);
    if (value < value_at(i - 1) || value < value_at(i + 1)) {
      continue;
    }
    Real left = low + std::max(i - 1, 0) * step;
    Real right = low + std::min(i + 1, samples) * step;
    for (int turn = 0; turn < 100; ++turn) {
      const Real inner_left = right - kGolden * (right - left);
      const Real inner_right = left + kGolden * (right - left);
      const Real value_left = f(inner_left);
      const Real value_right = f(inner_right);
      peak.offer(value_left, inner_left);
      peak.offer(value_right, inner_right);
      if (value_left > value_right) {
        right = inner_right;
      } else {
        left = inner_left;
      }
    }
  }
  return peak;
}

/// In the frame of the cylinder.
struct CylinderAndPolyhedron {
  Real radius;
  Real half_length;
  Polyhedron other;
};

// From the cylinder's closest point to `p`.
Vector wayFromCylinder(const CylinderAndPolyhedron& pair, const Vector& p) {
  const Real axis_distance = std::hypot(p.x(), p.y());
  const Real across = std::max<Real>(0, axis_distance - pair.radius);
  const Real along = std::max<Real>(0, std::abs(p.z()) - pair.half_length);
  const Real scale = across > 0 ? across / axis_distance : 0;
  return {scale * p.x(), scale * p.y(), std::copysign(along, p.z())};
}

Real reachOfCylinder(const CylinderAndPolyhedron& pair, const Vector& n) {
  return pair.radius * std::hypot(n.x(), n.y()) + pair.half_length * std::abs(n.z());
}

// The gap along the unit direction from the cylinder to the polyhedron.
Real gapOf(const CylinderAndPolyhedron& pair, const Vector& direction) {
  Real start = kUnbounded;
  for (const Vector& point : pair.other.points) {
    start = std::min(start, direction.dot(point));
  }
  return start - reachOfCylinder(pair, direction);
}

// From the face's inside to the cylinder's point nearest to its plane, if it projects inside.
Real distanceToFace(const CylinderAndPolyhedron& pair, const std::array<std::uint32_t, 3>& t) {
  const Polyhedron& p = pair.other;
  const Vector normal = normalOf(p, t).normalized();
  const Real across = std::hypot(normal.x(), normal.y());
  const Vector lowest(across > 0 ? -pair.radius * normal.x() / across : 0,
                      across > 0 ? -pair.radius * normal.y() / across : 0,
                      normal.z() < 0 ? pair.half_length : -pair.half_length);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector& from = p.points[t[k]];
    if ((p.points[t[(k + 1) % 3]] - from).cross(lowest - from).dot(normal) < 0) {
      return kUnbounded;
    }
  }
  const Real beyond = normal.dot(lowest - p.points[t[0]]);
  return beyond >= 0 ? beyond : kUnbounded;
}

// From corners and edges to the cylinder. They may be apart although something else overlaps, so
// their distance holds only if a plane between both bodies confirms it.
Real distanceApart(const CylinderAndPolyhedron& pair) {
  const Polyhedron& p = pair.other;
  Vector way = Vector::Constant(kUnbounded);
  const auto offer = [&](const Vector& point) {
    const Vector candidate = wayFromCylinder(pair, point);
    way = candidate.norm() < way.norm() ? candidate : way;
  };
  for (const Vector& point : p.points) {
    offer(point);
  }
  for (const auto& [i, j] : p.edges) {
    const Vector from = p.points[i];
    const Vector edge = p.points[j] - from;
    const Peak nearest = largestOn(
        0, 1, 8, [&](Real share) { return -wayFromCylinder(pair, from + share * edge).norm(); });
    offer(from + nearest.at * edge);
  }
  const Real distance = way.norm();
  return distance > 0 && gapOf(pair, way / distance) > distance / 2 ? distance : kUnbounded;
}

Real largestGapAcross(const CylinderAndPolyhedron& pair, const Vector& axis) {
  const Vector u = axis.unitOrthogonal();
  const Vector v = axis.normalized().cross(u);
  return largestOn(
             0, 6.2831853071795864769L, 400,
             [&](Real angle) { return gapOf(pair, std::cos(angle) * u + std::sin(angle) * v); })
      .value;
}

Real largestGap(const CylinderAndPolyhedron& pair) {
  const Polyhedron& p = pair.other;
  Real largest = std::max(gapOf(pair, Vector::UnitZ()), gapOf(pair, -Vector::UnitZ()));
  largest = std::max(largest, largestGapAcross(pair, Vector::UnitZ()));
  for (const auto& t : p.triangles) {
    largest = std::max(largest, gapOf(pair, -normalOf(p, t).normalized()));
  }
  for (const auto& [i, j] : p.edges) {
    largest = std::max(largest, largestGapAcross(pair, p.points[j] - p.points[i]));
  }
  return largest;
}

Real distanceToPolyhedron(const Cylinder& cylinder, const Pose& world_from_cylinder,
                          const ConvexGeometry& other, const Pose& world_from_other) {
  CylinderAndPolyhedron pair{cylinder.radius, cylinder.half_length,
                             polyhedronOf(other, world_from_other)};
  for (Vector& point : pair.other.points) {
    point = world_from_cylinder.rotation.cast<Real>().transpose() *
            (point - world_from_cylinder.translation.cast<Real>());
  }
  Real apart = distanceApart(pair);
  const Real gap = largestGap(pair);
  if (gap > 0) {
    for (const auto& t : pair.other.triangles) {
      apart = std::min(apart, distanceToFace(pair, t));
    }
  }
  return (apart < kUnbounded ? apart : gap) - pair.other.radius;
}

// ---- Two cylinders ----

struct Directed {
  Real gap{-kUnbounded};
  Vector direction{Vector::UnitX()};
};

Directed lookAlong(const PosedConvexPair& pair, const Vector& direction) {
  const Vector unit = direction.normalized();
  return {-extendedReach(*pair.b, pair.world_from_b, -unit) -
              extendedReach(*pair.a, pair.world_from_a, unit),
          unit};
}

// The best of a grid around `best`, rotated by `angle` so that ridges sometimes run along it.
Directed bestOfGrid(const PosedConvexPair& pair, Directed best, Real window, Real angle) {
  constexpr int kHalf = 4;
  const Vector first = best.direction.unitOrthogonal();
  const Vector second = best.direction.cross(first);
  const Vector u = std::cos(angle) * first + std::sin(angle) * second;
  const Vector v = best.direction.cross(u);
  const Vector center = best.direction;
  for (int i = -kHalf; i <= kHalf; ++i) {
    for (int j = -kHalf; j <= kHalf; ++j) {
      const Directed here = lookAlong(pair, center + window / kHalf * (i * u + j * v));
      best = here.gap > best.gap ? here : best;
    }
  }
  return best;
}

Directed refined(const PosedConvexPair& pair, Directed best) {
  Real angle = 0;
  for (Real window = 0.06L; window > 1e-16L; window *= 0.6L) {
    // Along a ridge the search may travel farther than the window.
    int idle = 0;
    for (int turn = 0; turn < 60 && idle < 4; ++turn) {
      const Directed next = bestOfGrid(pair, best, window, angle += 1.0L);
      idle = next.gap > best.gap + 1e-3L * window * window ? 0 : idle + 1;
      best = next;
    }
  }
  return best;
}

// Directions where kinks and ridges are likely: the axes of both frames.
std::vector<Vector> startDirections(const PosedConvexPair& pair) {
  constexpr int kCount = 3000;
  std::vector<Vector> directions;
  for (int i = 0; i < kCount; ++i) {
    const Real z = 1 - (2 * i + 1) / Real(kCount);
    const Real angle = 2.399963229728653L * i;
    const Real across = std::sqrt(1 - z * z);
    directions.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  for (const Pose* pose : {&pair.world_from_a, &pair.world_from_b}) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      directions.push_back(pose->rotation.col(k).cast<Real>());
      directions.push_back(-pose->rotation.col(k).cast<Real>());
    }
  }
  return directions;
}

Real distanceBySearch(const PosedConvexPair& pair) {
  constexpr std::size_t kStarts = 8;
  std::vector<Directed> found;
  for (const Vector& direction : startDirections(pair)) {
    found.push_back(lookAlong(pair, direction));
  }
  std::sort(found.begin(), found.end(),
            [](const Directed& a, const Directed& b) { return a.gap > b.gap; });
  std::vector<Directed> starts;
  for (const Directed& candidate : found) {
    const bool is_far = std::all_of(starts.begin(), starts.end(), [&](const Directed& start) {
      return start.direction.dot(candidate.direction) < 0.99L;
    });
    if (is_far && starts.size() < kStarts) {
      starts.push_back(candidate);
    }
  }
  Real largest = -kUnbounded;
  for (const Directed& start : starts) {
    largest = std::max(largest, refined(pair, start).gap);
  }
  return largest;
}

}  // namespace

Real cylinderReference(const PosedConvexPair& pair) {
  const auto* a = std::get_if<Cylinder>(pair.a);
  const auto* b = std::get_if<Cylinder>(pair.b);
  if (a != nullptr && b != nullptr) {
    return distanceBySearch(pair);
  }
  return a != nullptr ? distanceToPolyhedron(*a, pair.world_from_a, *pair.b, pair.world_from_b)
                      : distanceToPolyhedron(*b, pair.world_from_b, *pair.a, pair.world_from_a);
}

}  // namespace collision_monitor::test
