// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/fit_links.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/setup/setup_parts.h"
#include "support/robots/file_loader.h"
#include "support/robots/urdf_text.h"
#include "support/scratch_folder.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::linkXml;
using test::robotXml;
using Texts = std::vector<std::string>;

/// A base with a box, two equal rods, a tool without geometry.
const std::string kRobot = robotXml(
    linkXml("base", "<box size='0.2 0.2 0.2'/>") +
    linkXml("rod_1", "<cylinder radius='0.05' length='1'/>", "<origin xyz='0 0 0.5'/>") +
    linkXml("rod_2", "<cylinder radius='0.05' length='1'/>", "<origin xyz='0 0.5 0'/>") +
    "<link name='tool'/>" + jointXml("j1", "continuous", "base", "rod_1") +
    jointXml("j2", "continuous", "rod_1", "rod_2") + jointXml("j3", "continuous", "rod_2", "tool"));

CycleSetup build(const SetupOptions& options) {
  return buildSetup({test::describeText(kRobot)}, test::textLoader({}), options);
}

CycleSetup buildWithRules(const std::string& yaml) {
  SetupOptions options;
  options.default_limits = {1, 0.0, {}};
  options.shape_rules = {"rules.yaml", yaml};
  return build(options);
}

std::string errorOf(const std::string& yaml) {
  try {
    buildWithRules(yaml);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

/// "rod_1 collision_0/capsule" for each body.
Texts namesOf(const CycleSetup& setup) {
  Texts names;
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    names.push_back(setup.model.link(setup.bodies[i].link).name + " " + setup.labels[i].shape_name);
  }
  return names;
}

Texts warningsOf(const CycleSetup& setup, const std::string& about) {
  Texts texts;
  for (const Problem& warning : setup.report.warnings) {
    if (toString(warning).find(about) != std::string::npos) {
      texts.push_back(toString(warning));
    }
  }
  return texts;
}

std::vector<LinkFit> fit(const FitSettings& settings) {
  SetupReport report;
  const RobotModel model = readRobots({test::describeText(kRobot)}, test::textLoader({}), report);
  return fitLinks(model, settings, {}, report);
}

TEST(FitLinks, equalGeometries_areFittedOnce) {
  const std::vector<LinkFit> fits = fit({});
  ASSERT_EQ(fits.size(), 3U);
  EXPECT_EQ(fits[0].source, FitSource::fitted);
  EXPECT_EQ(fits[1].source, FitSource::fitted);
  EXPECT_EQ(fits[2].source, FitSource::repeated);
  EXPECT_EQ(radiusOf(fits[1].fits[0].shapes[0].shape), radiusOf(fits[2].fits[0].shapes[0].shape));
}

TEST(FitLinks, otherLimits_areAnotherFit) {
  FitSettings settings;
  settings.rules.resize(4);
  settings.rules[2].kinds = ShapeKinds{true, false, false, false};
  const std::vector<LinkFit> fits = fit(settings);
  EXPECT_EQ(fits[2].source, FitSource::fitted);
  EXPECT_TRUE(std::holds_alternative<Sphere>(fits[2].fits[0].shapes[0].shape));
}

TEST(FitLinks, secondStart_readsTheCache) {
  const test::ScratchFolder folder;
  FitSettings settings;
  settings.cache_directory = folder.path();
  fit(settings);
  const std::vector<LinkFit> fits = fit(settings);
  EXPECT_EQ(fits[0].source, FitSource::cached);
  EXPECT_EQ(fits[1].source, FitSource::cached);
  EXPECT_EQ(fits[2].source, FitSource::repeated);
}

TEST(FitLinks, progress_countsUpToTheTotal) {
  SetupReport report;
  const RobotModel model = readRobots({test::describeText(kRobot)}, test::textLoader({}), report);
  Texts links;
  std::size_t last = 0;
  fitLinks(
      model, {},
      [&](const std::string& link, std::size_t done, std::size_t total) {
        EXPECT_LE(last, done);
        EXPECT_EQ(total, 4U);
        last = done;
        links.push_back(link);
      },
      report);
  EXPECT_EQ(links, (Texts{"base", "rod_1", "rod_2", ""}));
  EXPECT_EQ(last, 4U);
}

TEST(FitLinks, sourcesHaveNames) {
  EXPECT_STREQ(nameOf(FitSource::cached), "cached");
  EXPECT_STREQ(nameOf(FitSource::given), "given");
}

TEST(SetupWithRules, kindsAndPadding_areObeyed) {
  const CycleSetup setup = buildWithRules(
      "shapes:\n"
      "  - {links: 'rod_*', kinds: [box]}\n"
      "  - {link: base, padding: 0.05}\n");
  EXPECT_EQ(namesOf(setup),
            (Texts{"base collision_0/box", "rod_1 collision_0/box", "rod_2 collision_0/box"}));
  const Eigen::Vector3d base = std::get<Box>(setup.bodies[0].shape).half_extents;
  EXPECT_LE((base - Eigen::Vector3d::Constant(0.15)).norm(), 1e-15);
  EXPECT_FALSE(setup.bodies[0].is_exact);
  const Eigen::Vector3d rod = std::get<Box>(setup.bodies[1].shape).half_extents;
  EXPECT_LE((rod - Eigen::Vector3d(0.05, 0.05, 0.5)).norm(), 1e-12);
}

TEST(SetupWithRules, givenShapes_replaceFits_areNamedAndProven) {
  const CycleSetup setup = buildWithRules(
      "shapes:\n"
      "  - {link: rod_2, kinds: [capsule]}\n"
      "  - link: rod_1\n"
      "    shapes:\n"
      "      - {kind: capsule, radius: 0.06, length: 0.5, xyz: [0, 0, 0.25]}\n"
      "      - {kind: box, size: [0.12, 0.12, 0.6], xyz: [0, 0, 0.75]}\n");
  EXPECT_EQ(namesOf(setup), (Texts{"base collision_0/box", "rod_1 given/capsule_1",
                                   "rod_1 given/box_2", "rod_2 collision_0/capsule"}));
  EXPECT_TRUE(setup.labels[1].is_proven);
  EXPECT_FALSE(setup.bodies[1].is_exact);
  EXPECT_EQ(setup.bodies[2].link_from_body.translation, Eigen::Vector3d(0.0, 0.0, 0.75));
  EXPECT_EQ(warningsOf(setup, "rules.yaml"), Texts());
}

TEST(SetupWithRules, shapesThatDoNotEnclose_nameLinkPointAndMillimetres) {
  const std::string error = errorOf(
      "shapes:\n"
      "  - link: base\n"
      "    shapes: [{kind: box, size: [0.2, 0.2, 0.194]}]\n"
      "  - link: rod_1\n"
      "    shapes: [{kind: sphere, radius: 0.5, xyz: [0, 0, 0.5]}]\n");
  EXPECT_NE(error.find("2 problems"), std::string::npos) << error;
  EXPECT_NE(error.find("rules.yaml line 2, shapes of link 'base': collision 'collision_0' is 3 mm "
                       "outside at ("),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("'unproven: true'"), std::string::npos) << error;
  EXPECT_NE(error.find("rules.yaml line 4, shapes of link 'rod_1'"), std::string::npos) << error;
}

TEST(SetupWithRules, unprovenShapes_areTakenWithAWarningAndSaySo) {
  const CycleSetup setup = buildWithRules(
      "shapes:\n"
      "  - link: base\n"
      "    unproven: true\n"
      "    shapes: [{kind: sphere, radius: 0.1}]\n");
  EXPECT_EQ(namesOf(setup)[0], "base unproven/sphere");
  EXPECT_FALSE(setup.labels[0].is_proven);
  EXPECT_TRUE(setup.labels[1].is_proven);
  EXPECT_EQ(warningsOf(setup, "73.21 mm outside").size(), 1U) << "0.1 sqrt(3) - 0.1";
}

TEST(SetupWithRules, linkWithoutGeometry_getsShapesAndPairs) {
  const CycleSetup setup = buildWithRules(
      "shapes:\n  - {link: tool, shapes: [{kind: sphere, radius: 0.1, xyz: [0, 0, 3]}]}\n");
  EXPECT_EQ(namesOf(setup).back(), "tool given/sphere");
  const LinkId tool = setup.model.findLink("tool").value();
  EXPECT_EQ(std::count_if(setup.link_pairs.begin(), setup.link_pairs.end(),
                          [&](const LinkPair& pair) { return pair.b == tool; }),
            3);
  EXPECT_TRUE(std::any_of(setup.checked.begin(), setup.checked.end(),
                          [&](const CheckedLinkPair& pair) { return pair.b == tool; }));
}

TEST(SetupWithRules, whatAFitWrites_isAcceptedWhenGivenBack) {
  SetupOptions options;
  options.default_limits = {3, 0.0, {}};
  const CycleSetup fitted = build(options);
  std::vector<NamedShapes> links;
  for (std::size_t i = 0; i < fitted.bodies.size(); ++i) {
    const std::string& link = fitted.model.link(fitted.bodies[i].link).name;
    if (links.empty() || links.back().link != link) {
      links.push_back({link, {}, ""});
    }
    links.back().shapes.push_back({fitted.bodies[i].shape, fitted.bodies[i].link_from_body});
  }
  const CycleSetup given = buildWithRules(writeShapeRules(links));
  ASSERT_EQ(given.bodies.size(), fitted.bodies.size());
  for (std::size_t i = 0; i < given.bodies.size(); ++i) {
    EXPECT_TRUE(given.labels[i].is_proven);
    EXPECT_LE(given.labels[i].widening, kGivenTolerance);
    EXPECT_NEAR(volumeOf(given.bodies[i].shape), volumeOf(fitted.bodies[i].shape),
                1e-3 * volumeOf(fitted.bodies[i].shape));
  }
}

TEST(MakeBodies, severalShapesOfOneGeometry_areNumbered) {
  CycleSetup setup;
  SetupReport report;
  setup.model = readRobots({test::describeText(kRobot)}, test::textLoader({}), report);
  LinkFit rod;
  rod.link = idAt<LinkId>(1);
  rod.padding = 0.01;
  rod.fits.resize(1);
  rod.fits[0].shapes.resize(2);
  rod.fits[0].shapes[0].shape = Sphere{0.3};
  rod.fits[0].shapes[0].geometry_from_body.translation.z() = 0.25;
  rod.fits[0].shapes[1].shape = Box{{0.1, 0.1, 0.3}};
  makeBodies({rod}, setup);
  EXPECT_EQ(namesOf(setup), (Texts{"rod_1 collision_0/sphere_1", "rod_1 collision_0/box_2"}));
  EXPECT_EQ(setup.bodies[0].link_from_body.translation, Eigen::Vector3d(0.0, 0.0, 0.75));
  EXPECT_NEAR(radiusOf(setup.bodies[0].shape), 0.31, 1e-15);
  EXPECT_NEAR(setup.bodies[0].bounding_radius, 0.31, 1e-12);
}

TEST(SetupWithRules, faultsOfTheFile_stopTheSetUp) {
  EXPECT_NE(errorOf("shapes: [{link: nobody, max_shapes: 1}]").find("'nobody'"), std::string::npos);
}

TEST(SetupOptions, badLimitsOfFits_areRefused) {
  SetupOptions options;
  options.default_limits.max_shapes = 0;
  options.default_limits.target_overshoot = -1.0;
  EXPECT_THROW(build(options), SetupError);
}

TEST(SetupOptions, unwritableCache_isOneWarning) {
  SetupOptions options;
  options.fit_cache = "/dev/null/fits";
  EXPECT_EQ(warningsOf(build(options), "cache of fits /dev/null/fits").size(), 1U);
}

TEST(SetupOptions, damagedCache_isOneWarningAndTheSameShapes) {
  const test::ScratchFolder folder;
  SetupOptions options;
  options.fit_cache = folder.path();
  const CycleSetup first = build(options);
  EXPECT_EQ(warningsOf(first, "cache of fits"), Texts());
  for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
    std::filesystem::resize_file(file, 40);
  }
  const CycleSetup second = build(options);
  EXPECT_EQ(warningsOf(second, "2 files that are damaged").size(), 1U);
  const CycleSetup third = build(options);
  EXPECT_EQ(warningsOf(third, "cache of fits"), Texts());
  for (std::size_t i = 0; i < first.bodies.size(); ++i) {
    EXPECT_EQ(radiusOf(first.bodies[i].shape), radiusOf(third.bodies[i].shape));
    EXPECT_EQ(first.bodies[i].link_from_body.rotation, third.bodies[i].link_from_body.rotation);
  }
}

}  // namespace
}  // namespace collision_monitor
