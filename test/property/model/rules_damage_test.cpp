// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "collision_monitor/model/shape_rules.h"
#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

const std::filesystem::path kPackage = COLLISION_MONITOR_SOURCE_DIR;

/// Replaces, removes or repeats a few pieces of the text, often with what YAML has a use for.
std::string damaged(std::string text, std::mt19937_64& random) {
  const std::string marks =
      "{}[],:#&*!|>'\"%@`-?\n\t \\\x01\xff"
      "0e.";
  const std::size_t faults = 1 + random() % 4;
  for (std::size_t i = 0; i < faults; ++i) {
    const std::size_t at = random() % text.size();
    const std::size_t length = random() % 12;
    switch (random() % 3) {
      case 0:
        text[at] = marks[random() % marks.size()];
        break;
      case 1:
        text.erase(at, length);
        break;
      default:
        text.insert(random() % text.size(), text.substr(at, length));
    }
  }
  return text;
}

bool isSound(const LinkRules& rules) {
  const auto isLength = [](double value) { return value >= 0.0 && value <= 1e6; };
  if (rules.given) {
    for (const PosedShape& shape : rules.given->shapes) {
      if (!isRigid(shape.geometry_from_body, 1e-12) || !isLength(radiusOf(shape.shape)) ||
          !isLength(coreHalfExtents(shape.shape).minCoeff()) ||
          !isLength(coreHalfExtents(shape.shape).maxCoeff())) {
        return false;
      }
    }
  }
  return isLength(rules.padding.value_or(0.0)) && isLength(rules.target_overshoot.value_or(0.0)) &&
         rules.max_shapes.value_or(1) >= 1 && rules.max_shapes.value_or(1) <= 1000;
}

TEST(RulesDamage, anyText_givesSoundRulesOrErrorsWithAPlace) {
  RobotDescription arm;
  arm.source = "arm6.urdf";
  arm.urdf_xml = test::readFile(kPackage / "urdf/arm6.urdf");
  arm.srdf_xml = test::readFile(kPackage / "urdf/arm6.srdf");
  SetupReport ignored;
  const RobotModel model = readRobots({arm}, test::oneTriangleLoader(), ignored);
  const std::vector<SrdfPairs> srdfs{readSrdf(arm, RobotId{0}, model, ignored)};
  const std::string whole = test::readFile(kPackage / "config/shape_rules.yaml");
  const std::string text = whole.substr(whole.find("\nshapes:"));
  std::mt19937_64 random(20260101);
  std::size_t refused = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string yaml = damaged(text, random);
    SetupReport report;
    const std::vector<LinkRules> rules = readShapeRules({"rules.yaml", yaml}, model, srdfs, report);
    ASSERT_EQ(rules.size(), model.links.size());
    for (const LinkRules& one : rules) {
      ASSERT_TRUE(isSound(one)) << yaml;
    }
    for (const Problem& problem : report.errors) {
      ASSERT_EQ(problem.where.rfind("rules.yaml", 0), 0U) << toString(problem);
    }
    refused += report.errors.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 500U) << "the damage does not reach the reader";
}

}  // namespace
}  // namespace collision_monitor
