// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/pipeline/setup.h"
#include "support/robots/urdf_text.h"

// Pairs of links that touch in the default pose: reported, and ignored where there is no SRDF.
namespace collision_monitor::test {
namespace {

const char* const kCylinder = "<cylinder radius='0.1' length='0.1'/>";

SetupOptions spheresAround(RefineGeometry geometry = RefineGeometry::mesh) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.default_limits.kinds = {true, false, false, false};
  options.refine.geometry = geometry;
  return options;
}

/// Two cylinders side by side with an arm between, this far apart: apart beyond 0.2 m; the spheres
/// around them, of 0.112 m, beyond 0.224 m.
CycleSetup cylinders(const std::string& travel, const SetupOptions& options = spheresAround(),
                     const std::string& srdf = "") {
  RobotDescription robot = describeText(robotXml(
      linkXml("base", kCylinder) + linkXml("arm", "<sphere radius='0.01'/>") +
      linkXml("tip", kCylinder) +
      jointXml("shoulder", "continuous", "base", "arm", "<origin xyz='0 0 1'/>") +
      jointXml("wrist", "continuous", "arm", "tip", "<origin xyz='" + travel + " 0 -1'/>")));
  robot.srdf_xml = srdf;
  return buildSetup({robot}, textLoader({}), options);
}

PairReason reasonOfEnds(const CycleSetup& setup) {
  EXPECT_EQ(setup.link_pairs.size(), 3U);
  return setup.link_pairs.at(1).reason;
}

TEST(DefaultOverlap, geometriesOverlap_ignoredWithAWarning) {
  const CycleSetup setup = cylinders("0.19");
  EXPECT_EQ(reasonOfEnds(setup), PairReason::default_overlap);
  ASSERT_EQ(setup.report.warnings.size(), 2U) << "and that no pair is left";
  EXPECT_EQ(setup.report.warnings[0].where, "robot 'r'");
  EXPECT_EQ(setup.report.warnings[0].found,
            "1 pair of links that overlaps in the default pose is not checked: 'base' and 'tip' "
            "(the geometries overlap by 10 mm)");
  EXPECT_NE(setup.report.warnings[0].advice.find("rosrun collision_monitor pairs"),
            std::string::npos);
}

TEST(DefaultOverlap, shapesOverlapAndGeometriesDoNot_staysChecked) {
  const CycleSetup setup = cylinders("0.21");
  EXPECT_EQ(reasonOfEnds(setup), PairReason::checked);
  EXPECT_TRUE(setup.report.warnings.empty());
}

TEST(DefaultOverlap, nothingIsRefined_theShapesDecide) {
  const CycleSetup setup = cylinders("0.21", spheresAround(RefineGeometry::none));
  EXPECT_EQ(reasonOfEnds(setup), PairReason::default_overlap);
  EXPECT_EQ(setup.report.warnings.at(0).found,
            "1 pair of links that overlaps in the default pose is not checked: 'base' and 'tip' "
            "(the enclosing shapes overlap by 14 mm)");
  EXPECT_EQ(reasonOfEnds(cylinders("0.23", spheresAround(RefineGeometry::none))),
            PairReason::checked);
}

TEST(DefaultOverlap, paddingAloneBringsThemTogether_staysChecked) {
  for (const RefineGeometry geometry : {RefineGeometry::mesh, RefineGeometry::none}) {
    SetupOptions options = spheresAround(geometry);
    options.padding = 0.03;
    const CycleSetup setup = cylinders("0.23", options);
    EXPECT_EQ(reasonOfEnds(setup), PairReason::checked);
    const std::string gap = geometry == RefineGeometry::mesh ? "30" : "6";
    EXPECT_EQ(setup.report.warnings.at(0).found,
              "1 pair of links that overlaps in the default pose is checked: 'base' and 'tip' "
              "(padding makes them overlap; the geometries are at least " +
                  gap + " mm apart)");
    EXPECT_EQ(reasonOfEnds(cylinders("0.19", options)), PairReason::default_overlap);
  }
}

TEST(DefaultOverlap, srdfOrSwitchedOff_staysCheckedAndIsReported) {
  const CycleSetup with_srdf = cylinders("0.19", spheresAround(), "<robot name='r'/>");
  EXPECT_EQ(reasonOfEnds(with_srdf), PairReason::checked);
  EXPECT_EQ(with_srdf.report.warnings.at(0).found,
            "1 pair of links that overlaps in the default pose is checked: 'base' and 'tip' "
            "(the geometries overlap by 10 mm)");
  SetupOptions options = spheresAround();
  options.ignore_default_overlap = false;
  EXPECT_EQ(reasonOfEnds(cylinders("0.19", options)), PairReason::checked);
}

}  // namespace
}  // namespace collision_monitor::test
