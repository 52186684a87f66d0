// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// The decision to read URDF ourselves (docs/decisions/urdf-reader.md) holds only as long as we
// read what urdfdom reads, wherever urdfdom can.
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>

#include "model/second_reader/second_reader.h"
#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

Pose toPose(const urdf::Pose& pose) {
  return {Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
              .toRotationMatrix(),
          {pose.position.x, pose.position.y, pose.position.z}};
}

void expectSame(const Pose& ours, const Pose& theirs) {
  EXPECT_LT((ours.rotation - theirs.rotation).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((ours.translation - theirs.translation).norm(), 1e-12);
}

JointType typeOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return JointType::revolute;
    case urdf::Joint::CONTINUOUS:
      return JointType::continuous;
    case urdf::Joint::PRISMATIC:
      return JointType::prismatic;
    case urdf::Joint::FLOATING:
      return JointType::floating;
    case urdf::Joint::PLANAR:
      return JointType::planar;
    default:
      return JointType::fixed;
  }
}

void expectSameLimits(const Joint& ours, const urdf::Joint& theirs) {
  if (!theirs.limits) {
    return;
  }
  if (ours.type == JointType::revolute || ours.type == JointType::prismatic) {
    EXPECT_EQ(ours.lower, theirs.limits->lower);
    EXPECT_EQ(ours.upper, theirs.limits->upper);
  }
  if (ours.type != JointType::fixed && theirs.limits->velocity > 0.0) {
    EXPECT_EQ(ours.max_velocity, theirs.limits->velocity);
  }
}

void expectSameMimic(const RobotModel& model, const Joint& ours, const urdf::Joint& theirs,
                     const urdf::ModelInterface& their_model) {
  if (ours.type == JointType::fixed || !theirs.mimic) {
    EXPECT_FALSE(ours.mimic);
    return;
  }
  ASSERT_TRUE(ours.mimic);
  // Chains are resolved here and not there; they have a unit test.
  if (!their_model.getJoint(theirs.mimic->joint_name)->mimic) {
    EXPECT_EQ(model.joint(ours.mimic->source).name, theirs.mimic->joint_name);
    EXPECT_EQ(ours.mimic->multiplier, theirs.mimic->multiplier);
    EXPECT_EQ(ours.mimic->offset, theirs.mimic->offset);
  }
}

void expectSameJoint(const RobotModel& model, const Joint& ours,
                     const urdf::ModelInterface& their_model) {
  const auto theirs = their_model.getJoint(ours.name);
  ASSERT_TRUE(theirs) << ours.name;
  SCOPED_TRACE(ours.name);
  EXPECT_EQ(ours.type, typeOf(*theirs));
  EXPECT_EQ(model.link(ours.parent).name, theirs->parent_link_name);
  EXPECT_EQ(model.link(ours.child).name, theirs->child_link_name);
  expectSame(ours.parent_from_joint, toPose(theirs->parent_to_joint_origin_transform));
  if (ours.type != JointType::fixed && ours.type != JointType::floating) {
    const Eigen::Vector3d axis(theirs->axis.x, theirs->axis.y, theirs->axis.z);
    EXPECT_LT((ours.axis - axis.normalized()).norm(), 1e-12);
  }
  expectSameLimits(ours, *theirs);
  expectSameMimic(model, ours, *theirs, their_model);
}

void expectSameGeometry(const Geometry& ours, const urdf::Geometry& theirs) {
  if (const auto* box = dynamic_cast<const urdf::Box*>(&theirs)) {
    EXPECT_EQ(std::get<Box>(ours).half_extents,
              0.5 * Eigen::Vector3d(box->dim.x, box->dim.y, box->dim.z));
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&theirs)) {
    EXPECT_EQ(std::get<Sphere>(ours).radius, sphere->radius);
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&theirs)) {
    EXPECT_EQ(std::get<Cylinder>(ours).radius, cylinder->radius);
    EXPECT_EQ(std::get<Cylinder>(ours).half_length, 0.5 * cylinder->length);
  } else {
    const auto* mesh = dynamic_cast<const urdf::Mesh*>(&theirs);
    ASSERT_TRUE(mesh);
    // Every mesh is the triangle (0,0,0) (1,0,0) (0,1,0): it shows the scale.
    const auto& vertices = std::get<TriangleMesh>(ours).vertices;
    EXPECT_EQ(vertices.at(1).x(), mesh->scale.x);
    EXPECT_EQ(vertices.at(2).y(), mesh->scale.y);
  }
}

/// @return how many shapes were compared. Where they lack shapes (capsules) or we
/// merged some, the lists differ in length and are not compared.
std::size_t expectSameShapes(const Link& ours, const urdf::ModelInterface& their_model) {
  const auto theirs = their_model.getLink(ours.name);
  EXPECT_TRUE(theirs) << ours.name;
  if (!theirs || theirs->collision_array.size() != ours.collisions.size()) {
    return 0;
  }
  SCOPED_TRACE(ours.name);
  for (std::size_t i = 0; i < ours.collisions.size(); ++i) {
    expectSame(ours.collisions[i].link_from_geometry, toPose(theirs->collision_array[i]->origin));
    expectSameGeometry(ours.collisions[i].geometry, *theirs->collision_array[i]->geometry);
  }
  return ours.collisions.size();
}

TEST(UrdfdomAgreement, everyRobotItAccepts_readsTheSame) {
  std::size_t robot_count = 0;
  std::size_t shape_count = 0;
  for (const test::RobotFile& file : test::allRobotFiles()) {
    SCOPED_TRACE(file.name);
    const RobotDescription description = test::describe(file);
    const urdf::ModelInterfaceSharedPtr theirs = urdf::parseURDF(description.urdf_xml);
    if (!theirs) {
      continue;
    }
    SetupReport report;
    const RobotModel ours = readRobots({description}, test::oneTriangleLoader(), report);
    for (const Problem& problem : report.errors) {
      ADD_FAILURE() << toString(problem);
    }
    for (const Problem& difference : askSecondReader({description}, ours)) {
      ADD_FAILURE() << toString(difference);
    }
    ++robot_count;
    EXPECT_EQ(ours.links.size(), theirs->links_.size());
    EXPECT_EQ(ours.joints.size(), theirs->joints_.size());
    EXPECT_EQ(ours.robots.at(0).name, theirs->getName());
    EXPECT_EQ(ours.link(ours.robots.at(0).root).name, theirs->getRoot()->name);
    for (const Joint& joint : ours.joints) {
      expectSameJoint(ours, joint, *theirs);
    }
    for (const Link& link : ours.links) {
      shape_count += expectSameShapes(link, *theirs);
    }
  }
  EXPECT_GT(robot_count, 0u) << "no robot was compared";
  EXPECT_GT(shape_count, 0u) << "no shape was compared";
  RecordProperty("robots", static_cast<int>(robot_count));
  RecordProperty("shapes", static_cast<int>(shape_count));
}

}  // namespace
}  // namespace collision_monitor
