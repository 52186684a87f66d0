// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/mesh_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/constants.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// A direction from A to B, and how far points of B move along it: |rate + gradient . x| in half an
/// interval, for x in B's frame from the center of its tree.
struct Direction {
  Vector3d normal;       ///< unit, frame of A
  Eigen::Vector3f in_a;  ///< at most of unit length
  Eigen::Vector3f in_b;
  float rate;
  Eigen::Vector3f gradient;
  float rounding;

  float travelOf(const Bound& of_b) const noexcept {
    return std::abs(rate + gradient.dot(of_b.center)) + gradient.cwiseAbs().dot(of_b.half) +
           rounding;
  }

  /// The same for all children of a node of B.
  Eigen::Array<float, MeshTreeNode::kWidth, 1> travelsOf(const MeshTreeNode& of_b) const noexcept {
    using Children = Eigen::Array<float, MeshTreeNode::kWidth, 1>;
    Children along = Children::Constant(rate);
    Children reach = Children::Constant(rounding);
    for (int axis = 0; axis < 3; ++axis) {
      along += gradient[axis] * Eigen::Map<const Children>(of_b.center[axis]);
      reach += std::abs(gradient[axis]) * Eigen::Map<const Children>(of_b.half[axis]);
    }
    return along.abs() + reach;
  }
};

/// Frame of A.
struct Search {
  const MeshPair& pair;
  RelativeMotion motion;
  double turn_length;
  double distance;                        ///< [m] plus the deviation of the motion
  double least{kInfinity};                ///< [m] likewise: of all that was parted
  std::array<Direction, 2> directions{};  ///< the last that parted triangles, the newest first
  std::size_t count{0};                   ///< of directions
};

/// Far turns of many joints in a row overflow: no comparison with such a number proves anything.
bool isFinite(const RelativeMotion& motion) noexcept {
  return std::isfinite(motion.deviation + motion.deviation_of_a + motion.velocity.norm() +
                       motion.turn.norm() + motion.center.norm());
}

RelativeMotion placedIn(const RelativeMotion& in_world, const Pose& world_from_a) noexcept {
  const Eigen::Matrix3d a_from_world = world_from_a.rotation.transpose();
  RelativeMotion motion = in_world;
  motion.center = a_from_world * (in_world.center - world_from_a.translation);
  motion.velocity = a_from_world * in_world.velocity;
  motion.turn = a_from_world * in_world.turn;
  return motion;
}

/// [m] How far points of B in a slot may move.
double travelOf(const Search& search, Slot slot_of_b) noexcept {
  const MeshPair& pair = search.pair;
  const Bound bound = boundAt(pair.b, slot_of_b);
  const Vector3d center = pair.a_from_b * (pair.b.center() + bound.center.cast<double>());
  return search.motion.velocityAt(center).norm() +
         search.turn_length * bound.half.cast<double>().norm();
}

Direction makeDirection(const Vector3d& normal, const Search& search) noexcept {
  const MeshPair& pair = search.pair;
  const Vector3d n = (1.0 - 1e-6) * normal;
  const Eigen::Matrix3d b_from_a = pair.a_from_b.rotation.transpose();
  const Vector3d across = n.cross(search.motion.turn);
  const Vector3d center = pair.a_from_b * pair.b.center();
  const double rate = n.dot(search.motion.velocity) + across.dot(center - search.motion.center);
  const double rounding =
      1e-6 * (search.motion.velocity.norm() +
              search.turn_length * ((center - search.motion.center).norm() + pair.b.radius()));
  return {normal,
          n.cast<float>(),
          (b_from_a * n).cast<float>(),
          static_cast<float>(rate),
          (b_from_a * across).cast<float>(),
          static_cast<float>(rounding)};
}

/// Whether a plane across a unit vector parts two triangles during the motion.
bool partsAlong(const Vector3d& n, const Triangle& of_a, const Triangle& of_b,
                Search& search) noexcept {
  const double gap = std::min({n.dot(of_b[0]), n.dot(of_b[1]), n.dot(of_b[2])}) -
                     std::max({n.dot(of_a[0]), n.dot(of_a[1]), n.dot(of_a[2])});
  const auto travel_of = [&](const Vector3d& corner) {
    return std::abs(n.dot(search.motion.velocityAt(corner)));
  };
  if (!(gap > search.distance)) {
    return false;
  }
  const double rest = gap - std::max({travel_of(of_b[0]), travel_of(of_b[1]), travel_of(of_b[2])});
  if (!(rest > search.distance)) {
    return false;
  }
  search.least = std::min(search.least, rest);
  return true;
}

/// Whether a known direction parts two triangles; it then comes first.
bool partsAsBefore(const Triangle& of_a, const Triangle& of_b, Search& search) noexcept {
  for (std::size_t i = 0; i < search.count; ++i) {
    if (partsAlong(search.directions[i].normal, of_a, of_b, search)) {
      std::swap(search.directions[0], search.directions[i]);
      return true;
    }
  }
  return false;
}

/// Tries the direction of the nearest points, and the normals of both triangles.
bool areParted(std::uint32_t a, std::uint32_t b, Search& search) noexcept {
  const Triangle& of_a = search.pair.a.triangles()[a];
  const Triangle of_b = triangleOfB(search.pair, b);
  if (partsAsBefore(of_a, of_b, search)) {
    return true;
  }
  const PointPair points = nearestPoints(of_a, of_b);
  const double distance = std::sqrt(points.squared_distance);
  if (!(distance > search.distance)) {
    return false;
  }
  const Vector3d between = (points.on_b - points.on_a) / distance;
  const auto towards_b = [&](const Vector3d& normal) {
    return normal.dot(between) < 0.0 ? Vector3d(-normal) : normal;
  };
  for (const Vector3d& normal :
       {between, towards_b(prepare(of_a).normal), towards_b(prepare(of_b).normal)}) {
    if (partsAlong(normal, of_a, of_b, search)) {
      search.directions[1] = search.directions[0];
      search.directions[0] = makeDirection(normal, search);
      search.count = std::min(search.count + 1, search.directions.size());
      return true;
    }
  }
  return false;
}

/// @return a bit for each child that the direction does not part from the other side.
std::uint32_t notParted(const Direction& direction, const OpenedPair& opened,
                        Search& search) noexcept {
  const Eigen::Vector3f outwards =
      opened.is_of_a ? direction.in_a : Eigen::Vector3f(-direction.in_b);
  const auto gaps = opened.triangle ? gapsAlong(*opened.node, *opened.triangle, outwards)
                                    : gapsAlong(*opened.node, opened.placed, outwards);
  using Children = Eigen::Array<float, MeshTreeNode::kWidth, 1>;
  const Children rest =
      Eigen::Map<const Children>(gaps.data()) -
      (opened.is_of_a ? Children::Constant(direction.travelOf(boundAt(search.pair.b, opened.other)))
                      : direction.travelsOf(*opened.node));
  const auto beyond = static_cast<float>(search.distance * (1.0 + 1e-6));
  std::uint32_t near = 0;
  auto least = static_cast<float>(search.least);
  for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
    const bool is_near = !(rest[slot] > beyond);
    near |= is_near ? 1U << slot : 0U;
    least = is_near ? least : std::min(least, rest[slot]);
  }
  search.least = std::min(search.least, static_cast<double>(least));
  return near;
}

/// Keeps how near the children come that are too far apart to come near.
void keepFar(const OpenedPair& opened, std::uint32_t far, double travel, Search& search) noexcept {
  const double reach = search.least + travel;
  double squared = reach * reach;
  for (; far != 0; far &= far - 1) {
    squared = std::min(squared, static_cast<double>(opened.bounds.squared[__builtin_ctz(far)]));
  }
  search.least = std::min(search.least, std::sqrt(squared) - travel);
}

/// Opens one side of a node pair, and queues the children that may come near.
void open(const MeshQueryMemory::NodePair& next, double travel, NodePairQueue& queue,
          Search& search) noexcept {
  OpenedPair opened;
  choose(search.pair, next.a, next.b, opened);
  std::uint32_t near = (1U << MeshTreeNode::kWidth) - 1;
  for (std::size_t i = 0; i < search.count && near != 0; ++i) {
    near &= notParted(search.directions[i], opened, search);
  }
  if (near == 0) {
    return;
  }
  const double reach = search.distance + travel;
  boundChildren(asLimit(reach * reach), opened);
  keepFar(opened, near & ~opened.nearer, travel, search);
  opened.nearer &= near;
  queue.pushNearer(opened);
}

bool doSurfacesStayApart(Search& search, MeshQueryMemory& memory, std::uint32_t& visits) noexcept {
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  while (!queue.empty()) {
    const MeshQueryMemory::NodePair next = queue.pop();
    const std::uint32_t child_a = childOf(search.pair.a, next.a);
    const std::uint32_t child_b = childOf(search.pair.b, next.b);
    if (!isTriangle(child_a) || !isTriangle(child_b)) {
      ++visits;
      open(next, travelOf(search, next.b), queue, search);
      continue;
    }
    visits += kVisitsToMeasure;
    if (!areParted(triangleAt(child_a), triangleAt(child_b), search)) {
      return false;
    }
  }
  return true;
}

/// A mesh that may come to hold points. Its frame is that of `solid`.
struct Holder {
  const MeshTree& solid;
  Pose solid_from_a;
  const RelativeMotion& motion;           ///< frame of A
  double deviation;                       ///< [m] of the points
  const ConvexHull::Face* last{nullptr};  ///< a point stayed beyond it
};

/// Whether a point stays outside, if it does not cross the surface. A closed mesh need not be asked
/// again later.
bool staysOutside(const Vector3d& in_a, Holder& holder, MeshQueryMemory& memory,
                  std::uint32_t& visits) noexcept {
  const Vector3d point = holder.solid_from_a * in_a;
  if (holder.solid.isClosed()) {
    return staysOutside(holder.solid, point, 0.0, memory, visits);
  }
  const Vector3d velocity = holder.solid_from_a.rotation * holder.motion.velocityAt(in_a);
  const auto stays_beyond = [&](const ConvexHull::Face& face) {
    return face.normal.dot(point) - face.offset >
           std::abs(face.normal.dot(velocity)) + holder.deviation;
  };
  if (isBeyondAnyFace(*holder.solid.openSurface(), holder.last, stays_beyond)) {
    return true;
  }
  return staysOutside(holder.solid, point, velocity.norm() + holder.deviation, memory, visits);
}

/// Whether all of a mesh stays outside, if it does not cross the surface.
bool stayOutside(const MeshTree& other, const Pose& a_from_other, Holder holder,
                 MeshQueryMemory& memory, std::uint32_t& visits) noexcept {
  if (!holder.solid.hasInside()) {
    return true;
  }
  const std::vector<Vector3d>& probes = holder.solid.isClosed() ? other.pieces() : other.probes();
  return std::all_of(probes.begin(), probes.end(), [&](const Vector3d& probe) {
    return staysOutside(a_from_other * probe, holder, memory, visits);
  });
}

}  // namespace

MeshClearance stayApart(const PlacedMesh& a, const PlacedMesh& b, const RelativeMotion& motion,
                        double distance, MeshQueryMemory& memory) noexcept {
  MeshClearance found;
  if (!isFinite(motion)) {
    return found;
  }
  const MeshPair pair = makeMeshPair(a, b);
  Search search{pair, placedIn(motion, a.world_from_mesh), motion.turn.norm(),
                distance + motion.deviation};
  found.is_proven =
      doSurfacesStayApart(search, memory, found.visits) &&
      stayOutside(b.tree, pair.a_from_b, {a.tree, Pose(), search.motion, motion.deviation}, memory,
                  found.visits) &&
      stayOutside(a.tree, Pose(),
                  {b.tree, inverse(pair.a_from_b), search.motion, motion.deviation_of_a}, memory,
                  found.visits);
  found.at_least = search.least - motion.deviation;
  return found;
}

}  // namespace collision_monitor
