// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/measure_elements.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

// Two hooked angles, whose surfaces are 0.02 m apart.
ElementDistance measureHooked(double cutoff) {
  const CycleSetup setup = geometrySetup({angleMesh(), angleMesh()}, SetupOptions());
  const Pose world_from_a;
  const Pose world_from_b = hookedPose();
  RefineMemory memory;
  const auto scratch = std::make_unique<RefineScratch>();
  ElementSearch search{10000, memory, *scratch, cutoff};
  return measureElements({setup.elements[0], world_from_a}, {setup.elements[1], world_from_b},
                         search);
}

TEST(MeasureElements, meshesNearerThanEnough_areMeasured) {
  const ElementDistance found = measureHooked(0.03);
  EXPECT_EQ(found.quality, Quality::exact);
  EXPECT_TRUE(found.is_complete);
  EXPECT_NEAR(found.measured.distance, 0.02, 1e-9);
}

TEST(MeasureElements, meshesFartherThanEnough_areProvenToBe) {
  const ElementDistance found = measureHooked(0.01);
  EXPECT_EQ(found.quality, Quality::lower_bound);
  EXPECT_TRUE(found.is_complete);
  EXPECT_FALSE(found.has_points);
  EXPECT_NEAR(found.measured.distance, 0.01, 1e-12);
}

// A ball of many triangles with a dent in its side, between two boxes.
TEST(MeasureElements, meshNearestWhereItsHullIs_measuredInAFewSteps) {
  TriangleMesh ball = sphereMesh(0.1, 40);
  ball.vertices[10 * 40] *= 0.5;  // on the equator, towards x
  const CycleSetup setup = geometrySetup({ball, Box{{0.1, 0.1, 0.1}}}, SetupOptions());
  ASSERT_FALSE(setup.elements[0].convex);
  const auto scratch = std::make_unique<RefineScratch>();
  const Pose world_from_a;
  for (const double side : {1.0, -1.0}) {
    Pose world_from_b;
    world_from_b.translation.x() = -side * 0.3;
    RefineMemory memory;
    ElementSearch search{10000, memory, *scratch};
    const ElementDistance found = measureElements({setup.elements[0], world_from_a},
                                                  {setup.elements[1], world_from_b}, search);
    EXPECT_EQ(found.quality, Quality::exact);
    EXPECT_TRUE(found.has_points);
    if (side > 0.0) {
      EXPECT_NEAR(found.measured.distance, 0.1, 1e-12);
      EXPECT_LT(found.work, 50U);
    } else {
      EXPECT_GT(found.measured.distance, 0.1 + 1e-6) << "the dent is before the box";
    }
  }
}

// A tool of two fingers passes above the mouth of a box without its top.
TEST(MeasureElements, beforeAnOpenMesh_outsideIsAtLeastTheDistanceOfTheHulls) {
  const TriangleMesh finger = prismMesh(0.005, 0.01, 6);
  const TriangleMesh tool =
      joined(finger, moved(finger, Eigen::Vector3d::Zero(), {-0.03, 0.0, 0.0}));
  const CycleSetup setup =
      geometrySetup({openBoxMesh(Eigen::Vector3d::Constant(0.5)), tool}, SetupOptions());
  const auto scratch = std::make_unique<RefineScratch>();
  const Pose world_from_a;
  RefineStore memory({RefineKind::front});
  for (int step = 0; step < 10; ++step) {
    const double gap = 0.03;
    Pose world_from_b;
    world_from_b.translation = {0.3 - 0.002 * step, 0.0, 0.5 + 0.01 + gap};
    ElementSearch search{10000, memory.of(0), *scratch};
    const ElementDistance found = measureElements({setup.elements[0], world_from_a},
                                                  {setup.elements[1], world_from_b}, search);
    EXPECT_GT(found.measured.distance, gap);
    EXPECT_GE(found.outside, gap - 1e-9) << step;
  }
}

}  // namespace
}  // namespace collision_monitor::test
