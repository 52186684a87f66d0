// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"
#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

const std::filesystem::path kPackage = COLLISION_MONITOR_SOURCE_DIR;

CycleSetup buildArm(const SetupOptions& options) {
  RobotDescription arm;
  arm.source = "arm6.urdf";
  arm.urdf_xml = test::readFile(kPackage / "urdf/arm6.urdf");
  arm.srdf_xml = test::readFile(kPackage / "urdf/arm6.srdf");
  return buildSetup({arm}, test::fileLoader(kPackage), options);
}

std::vector<std::string> shapesOf(const CycleSetup& setup, const std::string& link) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    if (setup.model.link(setup.bodies[i].link).name == link) {
      names.push_back(setup.labels[i].shape_name);
    }
  }
  return names;
}

TEST(ExampleRules, areAccepted_andDoWhatTheySay) {
  SetupOptions options;
  options.shape_rules = {"shape_rules.yaml", test::readFile(kPackage / "config/shape_rules.yaml")};
  const CycleSetup setup = buildArm(options);
  EXPECT_TRUE(std::all_of(setup.labels.begin(), setup.labels.end(),
                          [](const BodyLabel& label) { return label.is_proven; }));
  EXPECT_EQ(shapesOf(setup, "wrist_3_link"), std::vector<std::string>{"given/capsule"});
  EXPECT_EQ(shapesOf(setup, "tool0"),
            (std::vector<std::string>{"given/box_1", "given/rounded_box_2", "given/sphere_3"}));
  for (const std::string& finger : shapesOf(setup, "left_finger")) {
    EXPECT_NE(finger.find("box"), std::string::npos) << finger;
  }
  const CycleSetup plain = buildArm(SetupOptions());
  for (std::size_t i = 0; i < plain.bodies.size(); ++i) {
    if (plain.model.link(plain.bodies[i].link).name == "forearm_link") {
      EXPECT_NEAR(radiusOf(setup.bodies[i].shape), radiusOf(plain.bodies[i].shape) + 0.01, 1e-12);
    }
  }
}

/// Fits written to a file and given back stay proven, also where several shapes meet in a mesh.
TEST(WrittenRules, ofEveryRobotOfThePackage_areAcceptedWhenGivenBack) {
  for (const char* name : {"arm6", "dual_arm", "humanoid"}) {
    RobotDescription robot;
    robot.source = name;
    robot.urdf_xml = test::readFile(kPackage / "urdf" / (std::string(name) + ".urdf"));
    SetupReport report;
    const RobotModel model = readRobots({robot}, test::fileLoader(kPackage), report);
    FitSettings settings;
    settings.limits = {4, 0.0, {}};
    std::vector<NamedShapes> written;
    for (const LinkFit& fit : fitLinks(model, settings, {}, report)) {
      NamedShapes named{model.link(fit.link).name, {}, "fitted"};
      for (std::size_t i = 0; i < fit.fits.size(); ++i) {
        const Pose& place = model.link(fit.link).collisions[i].link_from_geometry;
        for (const Enclosure& enclosure : fit.fits[i].shapes) {
          named.shapes.push_back({enclosure.shape, place * enclosure.geometry_from_body});
        }
      }
      written.push_back(named);
    }
    settings.rules = readShapeRules({"written.yaml", writeShapeRules(written)}, model, {}, report);
    const std::vector<LinkFit> given = fitLinks(model, settings, {}, report);
    EXPECT_TRUE(report.errors.empty())
        << name << ": " << (report.errors.empty() ? "" : toString(report.errors.front()));
    EXPECT_EQ(given.size(), written.size());
  }
}

}  // namespace
}  // namespace collision_monitor
