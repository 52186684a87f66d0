// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "collision_monitor/model/shape_rules.h"
#include "support/robots/rules_text.h"

namespace collision_monitor {
namespace {

using test::readFields;
using test::readRules;
using test::ReadRules;
using Texts = std::vector<std::string>;

TEST(GivenShapes, givenShapes_havePlaceAndDimensions) {
  const ReadRules rules = readRules(
      "shapes:\n"
      "  - link: tool\n"
      "    unproven: true\n"
      "    shapes:\n"
      "      - {kind: sphere, radius: 0.1}\n"
      "      - {kind: capsule, radius: 0.05, length: 0.3, xyz: [0, 0, 0.15]}\n"
      "      - {kind: box, size: [0.1, 0.2, 0.3], rpy: [0, 0, 1.5707963267948966]}\n"
      "      - {kind: rounded_box, size: [0.1, 0.2, 0], radius: 0.01}\n");
  EXPECT_EQ(rules.errors, Texts());
  EXPECT_EQ(rules.warnings, Texts());
  const GivenShapes& given = rules.of("tool").given.value();
  EXPECT_TRUE(given.is_unproven);
  EXPECT_EQ(given.where, "rules.yaml line 2");
  ASSERT_EQ(given.shapes.size(), 4U);
  EXPECT_EQ(std::get<Sphere>(given.shapes[0].shape).radius, 0.1);
  EXPECT_EQ(std::get<Capsule>(given.shapes[1].shape).half_length, 0.15);
  EXPECT_EQ(given.shapes[1].geometry_from_body.translation, Eigen::Vector3d(0.0, 0.0, 0.15));
  EXPECT_EQ(std::get<Box>(given.shapes[2].shape).half_extents, Eigen::Vector3d(0.05, 0.1, 0.15));
  const Eigen::Vector3d turned_x = given.shapes[2].geometry_from_body.rotation.col(0);
  EXPECT_LE((turned_x - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_EQ(std::get<RoundedBox>(given.shapes[3].shape).half_extents,
            Eigen::Vector3d(0.05, 0.1, 0.0));
  EXPECT_EQ(std::get<RoundedBox>(given.shapes[3].shape).radius, 0.01);
}

TEST(GivenShapes, wrongShapes_areRefused) {
  for (const char* shape :
       {"sphere", "{radius: 1}", "{kind: ball, radius: 1}", "{kind: sphere}",
        "{kind: sphere, radius: -1}", "{kind: sphere, radius: 1, length: 2}",
        "{kind: capsule, radius: 1}", "{kind: box, size: 1}", "{kind: box, size: [1, 2]}",
        "{kind: box, size: [1, 2, -3]}", "{kind: box, size: [1, 2, x]}",
        "{kind: box, size: [1, 1, 1], radius: 1}", "{kind: rounded_box, size: [1, 1, 1]}",
        "{kind: sphere, radius: 1, xyz: [0, 0]}", "{kind: sphere, radius: 1, rpy: [0, 0, .nan]}",
        "{kind: sphere, radius: 1, at: [0, 0, 0]}"}) {
    EXPECT_EQ(readFields("shapes: [" + std::string(shape) + "]").errors.size(), 1U) << shape;
  }
  EXPECT_EQ(readFields("shapes:\n      - {kind: sphere, radius: 1}\n      - {kind: cone}").errors,
            Texts{"rules.yaml line 5, rule 1, shape 2: kind 'cone'; accepted: sphere, capsule, box "
                  "or rounded_box"});
  EXPECT_EQ(readFields("shapes: [{kind: sphere, radius: 1}]\n    max_shapes: 2").errors,
            Texts{"rules.yaml line 4, rule 1: max_shapes '2'; accepted: no limits of fits in a "
                  "rule that gives the shapes itself"});
}

TEST(GivenShapes, whatIsWritten_isReadBack) {
  Pose pose;
  pose.rotation = Eigen::Quaterniond(0.1, 0.7, -0.3, 0.5).normalized().toRotationMatrix();
  pose.translation = {0.123456789123, -1e-7, 12.5};
  Pose upright;  // roll and yaw turn about one axis
  upright.rotation << 0.0, 0.6, 0.8, 0.0, 0.8, -0.6, -1.0, 0.0, 0.0;
  const std::vector<PosedShape> shapes{{Sphere{1.0 / 3.0}, pose},
                                       {Capsule{0.1, 0.02}, upright},
                                       {Box{{0.1, 0.2, 1e-5}}, {}},
                                       {RoundedBox{{0.0, 0.2, 0.3}, 0.01}, pose}};
  const std::string yaml =
      writeShapeRules({{"arm_1", shapes, "sticks out 3 mm"}, {"hand", {shapes[1]}, ""}});
  const ReadRules rules = readRules(yaml);
  EXPECT_EQ(rules.errors, Texts()) << yaml;
  const auto& back = rules.of("arm_1").given.value().shapes;
  ASSERT_EQ(back.size(), shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Pose& expected = shapes[i].geometry_from_body;
    EXPECT_EQ(back[i].shape.index(), shapes[i].shape.index());
    EXPECT_NEAR(radiusOf(back[i].shape), radiusOf(shapes[i].shape), 1e-9);
    EXPECT_LE((coreHalfExtents(back[i].shape) - coreHalfExtents(shapes[i].shape)).norm(), 1e-9);
    EXPECT_LE((back[i].geometry_from_body.rotation - expected.rotation).norm(), 1e-8) << i;
    EXPECT_LE((back[i].geometry_from_body.translation - expected.translation).norm(), 1e-7);
  }
  EXPECT_EQ(rules.of("hand").given.value().shapes.size(), 1U);
}

}  // namespace
}  // namespace collision_monitor
