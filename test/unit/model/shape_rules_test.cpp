// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/shape_rules.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::linkXml;
using test::robotXml;
using Texts = std::vector<std::string>;

const char* const kSrdf =
    "<robot name='r'><group name='tip'><link name='hand'/><link name='tool'/></group>"
    "<group name='void'/></robot>";

/// base - arm_1 - arm_2 - hand - tool; the tool has no geometry.
RobotDescription describeArm(const std::string& prefix) {
  const std::string ball = "<sphere radius='0.1'/>";
  RobotDescription description = test::describeText(robotXml(
      linkXml("base", ball) + linkXml("arm_1", ball) + linkXml("arm_2", ball) +
      linkXml("hand", ball) + "<link name='tool'/>" +
      jointXml("j1", "continuous", "base", "arm_1") +
      jointXml("j2", "continuous", "arm_1", "arm_2") +
      jointXml("j3", "continuous", "arm_2", "hand") + jointXml("j4", "fixed", "hand", "tool")));
  description.srdf_xml = kSrdf;
  description.tf_prefix = prefix;
  return description;
}

struct ReadRules {
  RobotModel model;
  std::vector<LinkRules> rules;
  Texts errors;
  Texts warnings;

  const LinkRules& of(const std::string& link) const {
    return rules.at(index(model.findLink(link).value()));
  }
  /// Names of the links for which the rules set a maximum of shapes.
  Texts withMaximum() const {
    Texts names;
    for (std::size_t i = 0; i < rules.size(); ++i) {
      if (rules[i].max_shapes) {
        names.push_back(model.links[i].name);
      }
    }
    return names;
  }
};

ReadRules read(const std::string& yaml, const Texts& prefixes = {""}) {
  std::vector<RobotDescription> robots;
  for (const std::string& prefix : prefixes) {
    robots.push_back(describeArm(prefix));
  }
  ReadRules read;
  SetupReport ignored;
  read.model = readRobots(robots, test::textLoader({}), ignored);
  std::vector<SrdfPairs> srdfs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    srdfs.push_back(readSrdf(robots[i], idAt<RobotId>(i), read.model, ignored));
  }
  SetupReport report;
  read.rules = readShapeRules({"rules.yaml", yaml}, read.model, srdfs, report);
  for (const Problem& problem : report.errors) {
    read.errors.push_back(toString(problem));
  }
  for (const Problem& problem : report.warnings) {
    read.warnings.push_back(toString(problem));
  }
  return read;
}

/// The same with one rule for the link "arm_1"; the fields stand from line 3 on.
ReadRules readFields(const std::string& fields) {
  return read("shapes:\n  - link: arm_1\n    " + fields + "\n");
}

TEST(ShapeRules, allLimits_areRead) {
  const ReadRules rules = read(
      "shapes:\n"
      "  - {link: arm_1, kinds: [capsule, box], max_shapes: 3, target_overshoot: 0.02,\n"
      "     padding: 0.001}\n");
  EXPECT_EQ(rules.errors, Texts());
  EXPECT_EQ(rules.warnings, Texts());
  const LinkRules& arm = rules.of("arm_1");
  EXPECT_FALSE(arm.kinds->sphere);
  EXPECT_TRUE(arm.kinds->capsule);
  EXPECT_TRUE(arm.kinds->box);
  EXPECT_FALSE(arm.kinds->rounded_box);
  EXPECT_EQ(arm.max_shapes, 3U);
  EXPECT_EQ(arm.target_overshoot, 0.02);
  EXPECT_EQ(arm.padding, 0.001);
  EXPECT_FALSE(arm.given);
  EXPECT_FALSE(rules.of("arm_2").kinds);
}

TEST(ShapeRules, refine_isOneOfThreeWords) {
  EXPECT_EQ(readFields("refine: mesh").of("arm_1").refine, RefineGeometry::mesh);
  EXPECT_EQ(readFields("refine: hull").of("arm_1").refine, RefineGeometry::hull);
  EXPECT_EQ(readFields("refine: none").of("arm_1").refine, RefineGeometry::none);
  EXPECT_EQ(readFields("padding: 1").of("arm_1").refine, std::nullopt);
}

TEST(ShapeRules, laterRules_overrideFieldByField) {
  const ReadRules rules = read(
      "shapes:\n"
      "  - {links: '*', max_shapes: 2, padding: 0.01}\n"
      "  - {links: ['arm_?', hand], max_shapes: 5}\n"
      "  - {link: hand, kinds: box}\n");
  EXPECT_EQ(rules.errors, Texts());
  EXPECT_EQ(rules.of("base").max_shapes, 2U);
  EXPECT_EQ(rules.of("arm_2").max_shapes, 5U);
  EXPECT_EQ(rules.of("hand").max_shapes, 5U);
  EXPECT_EQ(rules.of("hand").padding, 0.01);
  EXPECT_TRUE(rules.of("hand").kinds->box);
  EXPECT_FALSE(rules.of("hand").kinds->capsule);
}

TEST(ShapeRules, patterns_matchWholeNames) {
  EXPECT_EQ(read("shapes: [{links: 'arm_*', max_shapes: 1}]").withMaximum(),
            (Texts{"arm_1", "arm_2"}));
  EXPECT_EQ(read("shapes: [{links: ['*a*'], max_shapes: 1}]").withMaximum(),
            (Texts{"base", "arm_1", "arm_2", "hand"}));
  EXPECT_EQ(read("shapes: [{links: ['a?m_?', 'b?s*e'], max_shapes: 1}]").withMaximum(),
            (Texts{"base", "arm_1", "arm_2"}));
  EXPECT_EQ(read("shapes: [{links: [arm], max_shapes: 1}]").errors.size(), 1U);
}

TEST(ShapeRules, severalRobots_namesWithAndWithoutPrefix) {
  const auto selected = [](const std::string& selector) {
    return read("shapes: [{" + selector + ", max_shapes: 1}]", {"left", "right"}).withMaximum();
  };
  EXPECT_EQ(selected("link: hand"), (Texts{"left/hand", "right/hand"}));
  EXPECT_EQ(selected("link: left/hand"), Texts{"left/hand"});
  EXPECT_EQ(selected("links: 'right/arm*'"), (Texts{"right/arm_1", "right/arm_2"}));
  EXPECT_EQ(selected("group: tip"), (Texts{"left/hand", "left/tool", "right/hand", "right/tool"}));
  EXPECT_EQ(selected("group: left/tip"), (Texts{"left/hand", "left/tool"}));
}

TEST(ShapeRules, givenShapes_havePlaceAndDimensions) {
  const ReadRules rules = read(
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

TEST(ShapeRules, linksWithoutGeometry_areWarnedOfUnlessTheyHaveShapes) {
  EXPECT_EQ(read("shapes: [{link: tool, max_shapes: 2}]").warnings,
            Texts{"rules.yaml line 1, rule 1: links without geometry; accepted: links with "
                  "<collision>, or 'shapes' for those without"});
  EXPECT_EQ(read("shapes:\n  - {link: tool, shapes: [{kind: sphere, radius: 1}]}\n"
                 "  - {link: tool, padding: 0.01}")
                .warnings,
            Texts());
}

TEST(ShapeRules, nothing_isNoRule) {
  EXPECT_EQ(read("").warnings.size(), 1U);
  EXPECT_EQ(read("# all commented out\n").warnings.size(), 1U);
  EXPECT_EQ(read("shapes:\n").warnings.size(), 1U);
  EXPECT_EQ(read("shapes: []\n").errors, Texts());
}

TEST(ShapeRules, noYaml_isOneErrorWithItsLine) {
  const Texts errors = read("shapes:\n  - {link: arm_1\n").errors;
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].rfind("rules.yaml line 3: text that is no YAML: ", 0), 0U) << errors[0];
  EXPECT_EQ(read("\t- x").errors.size(), 1U);
  EXPECT_EQ(read("shapes: *nowhere").errors.size(), 1U);
}

TEST(ShapeRules, wrongOutline_isNamed) {
  EXPECT_EQ(read("[1, 2]").errors,
            Texts{"rules.yaml line 1: [1, 2]; accepted: YAML with a list of rules under 'shapes'"});
  EXPECT_EQ(read("shape: []").errors,
            (Texts{"rules.yaml line 1: an unknown key, 'shape'; accepted: shapes",
                   "rules.yaml line 1: no 'shapes'; accepted: YAML with a list of rules under "
                   "'shapes'"}));
  EXPECT_EQ(read("shapes: {link: a}").errors,
            Texts{"rules.yaml line 1: shapes a map of 1; accepted: a list of rules"});
  EXPECT_EQ(read("shapes: [arm_1]").errors,
            Texts{"rules.yaml line 1, rule 1: 'arm_1'; accepted: a rule with its fields"});
}

TEST(ShapeRules, everyProblemOfTheFile_isReportedWithItsLine) {
  const ReadRules rules = read(
      "shapes:\n"
      "  - link: elbow\n"
      "    max_shapes: 2.5\n"
      "  - links: [arm_1, 'leg_*']\n"
      "    padding: -0.1\n"
      "    paddding: 1\n"
      "  - group: tail\n"
      "    kinds: [ball]\n"
      "  - max_shapes: 1\n"
      "  - link: base\n"
      "    group: tip\n"
      "  - group: void\n"
      "    target_overshoot: .nan\n");
  EXPECT_EQ(
      rules.errors,
      (Texts{
          "rules.yaml line 2, rule 1: link 'elbow', which is unknown; accepted: links of the "
          "robots: 'base', 'arm_1', 'arm_2', 'hand' and 'tool'",
          "rules.yaml line 3, rule 1: max_shapes '2.5'; accepted: a whole number",
          "rules.yaml line 4, rule 2: links 'leg_*', which matches none; accepted: links of the "
          "robots: 'base', 'arm_1', 'arm_2', 'hand' and 'tool'",
          "rules.yaml line 5, rule 2: padding '-0.1'; accepted: a number from 0 to 1000",
          "rules.yaml line 6, rule 2: an unknown key, 'paddding'; accepted: group, kinds, link, "
          "links, max_shapes, padding, refine, shapes, target_overshoot and unproven",
          "rules.yaml line 7, rule 3: group 'tail'; accepted: a group of an SRDF: 'tip' and "
          "'void'",
          "rules.yaml line 8, rule 3: kinds [ball]; accepted: a list of sphere, capsule, box and "
          "rounded_box",
          "rules.yaml line 9, rule 4: a rule without links; accepted: one of link, links and group",
          "rules.yaml line 10, rule 5: two selections of links; accepted: one of link, links and "
          "group",
          "rules.yaml line 10, rule 5: a rule that sets nothing; accepted: kinds, max_shapes, "
          "target_overshoot, padding, refine or shapes",
          "rules.yaml line 12, rule 6: group 'void'; accepted: a group that has links",
          "rules.yaml line 13, rule 6: target_overshoot '.nan'; accepted: a number from 0 to "
          "1e+06"}));
}

TEST(ShapeRules, wrongValues_areRefused) {
  for (const char* fields : {"max_shapes: 0",
                             "max_shapes: 1001",
                             "max_shapes: -1",
                             "max_shapes: many",
                             "max_shapes: [1]",
                             "padding: .inf",
                             "padding: 1e999",
                             "padding: 0x10",
                             "padding: {a: 1}",
                             "padding:",
                             "target_overshoot: -1e-9",
                             "kinds: []",
                             "kinds: [[box]]",
                             "kinds: Box",
                             "refine: exact",
                             "refine: [mesh]",
                             "unproven: true",
                             "shapes: []",
                             "shapes: {kind: sphere, radius: 1}",
                             "shapes: 3"}) {
    EXPECT_EQ(readFields(fields).errors.size(), 1U) << fields;
  }
  EXPECT_EQ(readFields("padding: 1\n    padding: 2").errors,
            Texts{"rules.yaml line 4, rule 1: padding a second time; accepted: each key once"});
  EXPECT_EQ(readFields("padding: 1\n    [1]: 2").errors.size(), 1U) << "a key that is a list";
}

TEST(ShapeRules, wrongShapes_areRefused) {
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

TEST(ShapeRules, whatIsWritten_isReadBack) {
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
  const ReadRules rules = read(yaml);
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
