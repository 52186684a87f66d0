// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "collision_monitor/model/kinematics.h"
#include "model/mesh_files/triangulate.h"
#include "model/mesh_loading/mesh_store.h"
#include "model/urdf/merge_capsules.h"
#include "support/fixed_seed.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

Eigen::Vector3d point(double reach) {
  return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
}

Pose pose() {
  const Eigen::Vector4d q(between(-1, 1), between(-1, 1), between(-1, 1), between(0.1, 1));
  return {Eigen::Quaterniond(q).normalized().toRotationMatrix(), point(2.0)};
}

Joint joint(JointType type) {
  Joint result;
  result.type = type;
  result.axis = (point(1.0) + Eigen::Vector3d(0.0, 0.0, 2.0)).normalized();
  result.parent_from_joint = pose();
  return result;
}

RC_GTEST_PROP(KinematicsLaws, everyJoint_movesRigidly, ()) {
  for (const JointType type : {JointType::fixed, JointType::revolute, JointType::continuous,
                               JointType::prismatic, JointType::planar, JointType::floating}) {
    JointPositions positions;
    for (int i = 0; i < 7; ++i) {
      positions.push_back(between(0.1, 3.0));
    }
    RC_ASSERT(isRigid(parentFromChild(joint(type), positions), 1e-12));
  }
}

RC_GTEST_PROP(KinematicsLaws, revoluteJoint_addsItsAngles, ()) {
  Joint turning = joint(JointType::revolute);
  turning.parent_from_joint = Pose{};
  const double a = between(-3.0, 3.0);
  const double b = between(-3.0, 3.0);
  const Pose in_two = parentFromChild(turning, {a}) * parentFromChild(turning, {b});
  const Pose at_once = parentFromChild(turning, {a + b});
  RC_ASSERT((in_two.rotation - at_once.rotation).cwiseAbs().maxCoeff() < 1e-14);
}

RC_GTEST_PROP(KinematicsLaws, planarJoint_staysInItsPlaneAndKeepsLengths, ()) {
  Joint planar = joint(JointType::planar);
  planar.parent_from_joint = Pose{};
  planar.axis =
      (point(1.0) + Eigen::Vector3d(0.0, 0.0, between(-2.0, 2.0)) + Eigen::Vector3d(1e-3, 0.0, 0.0))
          .normalized();
  const double x = between(-2.0, 2.0);
  const double y = between(-2.0, 2.0);
  const Eigen::Vector3d moved = parentFromChild(planar, {x, y, between(-3.0, 3.0)}).translation;
  RC_ASSERT(std::abs(moved.dot(planar.axis)) < 1e-9);
  RC_ASSERT(std::abs(moved.norm() - std::hypot(x, y)) < 1e-9);
}

RC_GTEST_PROP(KinematicsLaws, movedRoot_movesEveryLinkAlike, ()) {
  using test::jointXml;
  const RobotModel model =
      test::readText(test::robotXml("<link name='a'/><link name='b'/><link name='c'/>" +
                                    jointXml("j", "continuous", "a", "b", "<axis xyz='1 2 3'/>") +
                                    jointXml("k", "floating", "b", "c")))
          .model;
  JointPositions positions;
  for (std::size_t i = 0; i < model.variable_count; ++i) {
    positions.push_back(between(0.1, 2.0));
  }
  const Pose world_from_root = pose();
  std::vector<Pose> at_origin;
  std::vector<Pose> moved;
  placeLinks(model, positions, {Pose{}}, at_origin);
  placeLinks(model, positions, {world_from_root}, moved);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Pose expected = world_from_root * at_origin[i];
    RC_ASSERT((moved[i].translation - expected.translation).norm() < 1e-12);
    RC_ASSERT((moved[i].rotation - expected.rotation).cwiseAbs().maxCoeff() < 1e-12);
  }
}

RC_GTEST_PROP(MergeCapsulesLaws, capsule_holdsEveryPointOfTheThree, ()) {
  const double radius = between(0.01, 0.3);
  const double half_length = between(0.0, 0.5);
  CollisionElement cylinder;
  cylinder.link_from_geometry = pose();
  cylinder.geometry = Cylinder{half_length, radius};
  std::vector<CollisionElement> collisions{cylinder};
  for (const double end : {-half_length, half_length}) {
    CollisionElement sphere;
    sphere.link_from_geometry.translation =
        cylinder.link_from_geometry * Eigen::Vector3d(0.0, 0.0, end) +
        between(0.0, 0.9) * kCapsuleTolerance * point(1.0).normalized();
    sphere.geometry = Sphere{radius + between(-0.9, 0.9) * kCapsuleTolerance};
    collisions.push_back(sphere);
  }
  std::vector<CollisionElement> merged = collisions;
  mergeCapsules(merged);
  RC_ASSERT(merged.size() == 1u);
  const Shape capsule = std::get<Capsule>(merged[0].geometry);
  const Pose geometry_from_link = inverse(merged[0].link_from_geometry);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d direction = (point(1.0) + Eigen::Vector3d(0, 0, 1e-3)).normalized();
    for (std::size_t s = 1; s < collisions.size(); ++s) {
      const Eigen::Vector3d on_sphere = collisions[s].link_from_geometry.translation +
                                        std::get<Sphere>(collisions[s].geometry).radius * direction;
      const double distance = signedDistanceTo(capsule, geometry_from_link * on_sphere);
      RC_ASSERT(distance < 1e-14);
    }
    const Eigen::Vector2d rim = radius * direction.head<2>().normalized();
    const double distance =
        signedDistanceTo(capsule, {rim.x(), rim.y(), between(-half_length, half_length)});
    RC_ASSERT(distance < 1e-14);
    RC_ASSERT(distance > -3.0 * kCapsuleTolerance);
  }
}

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].cross(mesh.vertices[t[1]]).dot(mesh.vertices[t[2]]) / 6.0;
  }
  return volume;
}

RC_GTEST_PROP(ScaledMeshLaws, closedMesh_keepsItsOutsideUnderAnyScale, ()) {
  const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  Eigen::Vector3d scale(between(0.1, 3.0), between(0.1, 3.0), between(0.1, 3.0));
  for (Eigen::Index i = 0; i < 3; ++i) {
    scale[i] *= *rc::gen::arbitrary<bool>() ? -1.0 : 1.0;
  }
  const double expected = std::abs(scale.prod()) / 6.0;
  RC_ASSERT(std::abs(signedVolume(scaled(tetrahedron, scale)) - expected) < 1e-12);
}

/// A polygon that any ray from its center leaves once, and so does not cross itself.
std::vector<Eigen::Vector3d> starPolygon() {
  const int count = *rc::gen::inRange(4, 24);
  std::vector<Eigen::Vector3d> polygon;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    const double radius = between(0.2, 2.0);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return polygon;
}

RC_GTEST_PROP(TriangulateLaws, simplePolygon_isCoveredExactly, ()) {
  const std::vector<Eigen::Vector3d> flat = starPolygon();
  double expected = 0.0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    expected += 0.5 * flat[i].cross(flat[(i + 1) % flat.size()]).z();
  }
  const Pose world_from_polygon = pose();
  std::vector<Eigen::Vector3d> polygon;
  for (const Eigen::Vector3d& corner : flat) {
    polygon.push_back(world_from_polygon * corner);
  }
  double area = 0.0;
  for (const auto& t : triangulate(polygon)) {
    area += 0.5 * (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]).norm();
  }
  RC_ASSERT(std::abs(area - expected) < 1e-9);
}

}  // namespace
}  // namespace collision_monitor
