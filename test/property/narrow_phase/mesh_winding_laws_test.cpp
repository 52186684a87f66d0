// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_depth/point_on_mesh.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/mesh_inside/mesh_winding.h"
#include "support/allocation_guard.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

// Laws of the inside of meshes with holes, held against the sum over all triangles.
namespace collision_monitor::test::mesh_winding_laws {
namespace {

using Eigen::Vector3d;

MeshQueryMemory& memory() {
  static const auto kept = std::make_unique<MeshQueryMemory>();
  return *kept;
}

double millimetres(int low, int high) { return 1e-3 * *rc::gen::inRange(low, high + 1); }

Vector3d anyPoint(int reach) {
  return {millimetres(-reach, reach), millimetres(-reach, reach), millimetres(-reach, reach)};
}

TriangleMesh anyClosed() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return boxMesh({millimetres(50, 500), millimetres(50, 500), millimetres(50, 500)});
    case 1:
      return sphereMesh(0.5, *rc::gen::inRange(4, 30));
    case 2:
      return prismMesh(0.3, 0.4, *rc::gen::inRange(3, 40));
    default:
      return bumpyMesh(1.0, *rc::gen::inRange(4, 24));
  }
}

/// No two triangles share an edge, so the rim is too long to be summed by side and the surface
/// has moments.
TriangleMesh allApart() {
  const TriangleMesh whole = sphereMesh(0.5, 40);
  const double share = 1e-3 * *rc::gen::inRange(900, 1000);
  TriangleMesh mesh;
  for (const auto& triangle : whole.triangles) {
    const Vector3d center =
        (whole.vertices[triangle[0]] + whole.vertices[triangle[1]] + whole.vertices[triangle[2]]) /
        3.0;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.triangles.push_back({first, first + 1, first + 2});
    for (const std::uint32_t corner : triangle) {
      mesh.vertices.push_back(center + share * (whole.vertices[corner] - center));
    }
  }
  return mesh;
}

/// A closed mesh that lost some triangles, and some were turned; or one with a long rim.
TriangleMesh anyOpen() {
  if (*rc::gen::inRange(0, 6) == 0) {
    return allApart();
  }
  TriangleMesh mesh = anyClosed();
  const int holes = *rc::gen::inRange(1, 20);
  for (int i = 0; i < holes && mesh.triangles.size() > 1; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, mesh.triangles.size());
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(at));
    std::swap(mesh.triangles[at / 2][0], mesh.triangles[at / 2][1]);
  }
  return mesh;
}

/// As van Oosterom and Strackee have it, with an arc tangent for each triangle.
double solidAngle(const Triangle& triangle, const Vector3d& point) {
  const Vector3d a = triangle[0] - point;
  const Vector3d b = triangle[1] - point;
  const Vector3d c = triangle[2] - point;
  const double base = a.norm() * b.norm() * c.norm();
  const double sides = a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), base + sides);
}

double sumOfAll(const MeshTree& tree, const Vector3d& point) {
  double angles = 0.0;
  for (const Triangle& triangle : tree.triangles()) {
    angles += solidAngle(triangle, point);
  }
  return angles / (4.0 * kPi);
}

double distanceTo(const MeshTree& tree, const Vector3d& point) {
  return nearestOnMesh(tree, point, kNone, {}, memory()).distance;
}

Vector3d pointOff(const MeshTree& tree) {
  const Vector3d point = anyPoint(700);
  RC_PRE(distanceTo(tree, point) > 1e-6);
  return point;
}

RC_GTEST_PROP(MeshWindingLaws, trianglesThatAreAllApart_haveMoments, ()) {
  RC_ASSERT(!test::openTree(allApart()).openSurface()->moments.empty());
}

RC_GTEST_PROP(MeshWindingLaws, hierarchy_isOffTheSumOfAllTrianglesByNoMoreThanIsTold, ()) {
  const MeshTree tree = test::openTree(anyOpen());
  const Vector3d point = pointOff(tree);
  const double exact = sumOfAll(tree, point);
  for (const double error : {0.3, 1e-2, 1e-4, 1e-9}) {
    const WindingNumber number = windingNumber(tree, point, error, memory());
    RC_ASSERT(number.error <= error);
    RC_ASSERT(std::abs(number.value - exact) <= number.error);
    const double limit = *rc::gen::inRange(1, 100) / 100.0;
    const WindingNumber by_limit = windingByLimit(tree, point, limit, error, memory());
    RC_ASSERT(std::abs(by_limit.value - exact) <= by_limit.error);
    RC_ASSERT(by_limit.error <= error ||
              std::abs(std::abs(by_limit.value) - limit) > by_limit.error);
  }
}

/// Points in the walls that a line of sight adds, and straight below corners.
RC_GTEST_PROP(MeshWindingLaws, pointsInLineWithTheRim_haveTheSumOfAllTriangles, ()) {
  const MeshTree tree = test::openTree(anyOpen());
  const auto& triangle =
      tree.triangles()[*rc::gen::inRange<std::size_t>(0, tree.triangles().size())];
  const Vector3d on_side = triangle[0] + millimetres(0, 1000) * (triangle[1] - triangle[0]);
  const Vector3d sight = *rc::gen::element(Vector3d(0.271828, 0.141421, 1.0), Vector3d(0, 0, 1));
  const Vector3d point = on_side + millimetres(-500, 500) * sight;
  RC_PRE(distanceTo(tree, point) > 1e-4);
  const WindingNumber number = windingNumber(tree, point, 1e-9, memory());
  RC_ASSERT(number.error <= 1e-9);
  RC_ASSERT(std::abs(number.value - sumOfAll(tree, point)) <= 1e-9);
}

RC_GTEST_PROP(MeshWindingLaws, closedMeshes_haveTheInsideOfTheExactTest, ()) {
  const TriangleMesh mesh = anyClosed();
  const MeshTree closed(mesh, true);
  const MeshTree tree = test::openTree(mesh);
  const Vector3d point = pointOff(tree);
  const bool is_inside = isInside(closed, point, memory());
  const WindingNumber number = windingNumber(tree, point, 1e-3, memory());
  RC_ASSERT(std::abs(std::abs(number.value) - (is_inside ? 1.0 : 0.0)) <= 1e-3);
  RC_ASSERT(lookInside(tree, point, memory()).is_inside == is_inside);
}

RC_GTEST_PROP(MeshWindingLaws, oneRigidMotionOnBoth_changesNothing, ()) {
  TriangleMesh mesh = anyOpen();
  // Vertices that are one but for rounding would be one or not, after the motion.
  constexpr double kGrid = 1e9;
  for (Vector3d& vertex : mesh.vertices) {
    vertex = (kGrid * vertex).array().round() / kGrid;
  }
  const Vector3d turn = anyPoint(3000);
  const Vector3d shift = anyPoint(1000);
  const MeshTree tree = test::openTree(mesh);
  const Vector3d point = pointOff(tree);
  // The same way as the vertices go.
  const Vector3d image = moved(TriangleMesh{{point}, {}}, turn, shift).vertices[0];
  const MeshTree elsewhere = test::openTree(moved(mesh, turn, shift));
  const double number = windingNumber(tree, point, 1e-9, memory()).value;
  RC_ASSERT(std::abs(number - windingNumber(elsewhere, image, 1e-9, memory()).value) < 1e-7);
}

RC_GTEST_PROP(MeshWindingLaws, decision_isThatOfTheSumButNearOneHalf, ()) {
  const MeshTree tree = test::openTree(anyOpen());
  const Vector3d point = pointOff(tree);
  const double beyond = std::abs(sumOfAll(tree, point)) - 0.5;
  const bool is_inside = lookInside(tree, point, memory()).is_inside;
  RC_ASSERT(!is_inside || beyond > 0.0);
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : tree.triangles()) {
    for (const Vector3d& corner : triangle) {
      box.extend(corner);
    }
  }
  RC_ASSERT(is_inside || !(beyond > 0.02) || !box.contains(point));
}

RC_GTEST_PROP(MeshWindingLaws, waysShorterThanTheHold_changeNothing, ()) {
  const MeshTree tree = test::openTree(anyOpen());
  const Vector3d point = pointOff(tree);
  const PointInMesh lies = lookInside(tree, point, memory());
  const double delta = 0.999 * std::min(lies.hold, distanceTo(tree, point));
  RC_PRE(delta > 0.0);
  const Vector3d side = anyPoint(1000) + Vector3d(1e-4, 0, 0);
  const Vector3d there = point + delta * side.normalized();
  // Outside of the box of the mesh nothing is asked.
  const PointInMesh then = lookInside(tree, there, memory());
  const double beyond = std::abs(sumOfAll(tree, there)) - 0.5;
  const bool stays = lies.is_inside ? beyond > -1e-9 : !then.is_inside;
  RC_ASSERT(stays);
}

RC_GTEST_PROP(MeshWindingLaws, whatStaysOutside_isOutsideAfterShorterWays, ()) {
  const MeshTree tree = test::openTree(anyOpen());
  const Vector3d point = pointOff(tree);
  const PointInMesh lies = lookInside(tree, point, memory());
  const double travel = *rc::gen::inRange(1, 300) / 1000.0 * distanceTo(tree, point);
  std::uint32_t visits = 0;
  const bool stays = staysOutside(tree, point, travel, memory(), visits);
  RC_ASSERT(!(stays && lies.is_inside));
  RC_ASSERT(stays || lies.is_inside || !(std::max(lies.hold, leastHold(tree)) > travel));
  RC_PRE(stays && travel > leastHold(tree));
  const Vector3d side = anyPoint(1000) + Vector3d(1e-4, 0, 0);
  const Vector3d there = point + 0.999 * travel * side.normalized();
  RC_ASSERT(!lookInside(tree, there, memory()).is_inside);
}

RC_GTEST_PROP(MeshWindingLaws, queries_doNotAllocate, ()) {
  const MeshTree tree = test::openTree(anyOpen());
  const Vector3d point = anyPoint(700);
  memory();
  const AllocationGuard guard;
  const PointInMesh lies = lookInside(tree, point, memory());
  const WindingNumber number = windingNumber(tree, point, 1e-9, memory());
  const std::size_t allocated = guard.count();
  RC_ASSERT(allocated == 0U);
  RC_ASSERT(lies.hold >= 0.0);
  RC_ASSERT(std::isfinite(number.value));
}

}  // namespace
}  // namespace collision_monitor::test::mesh_winding_laws
