// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/measure_elements.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/geometry_setup.h"

namespace collision_monitor::test {
namespace {

// Two hooked angles, whose surfaces are 0.02 m apart.
ElementDistance measureHooked(double enough) {
  const CycleSetup setup = geometrySetup({angleMesh(), angleMesh()}, SetupOptions());
  const Pose world_from_a;
  const Pose world_from_b = hookedPose();
  RefineMemory memory;
  const auto scratch = std::make_unique<RefineScratch>();
  ElementSearch search{10000, memory, *scratch, enough};
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

}  // namespace
}  // namespace collision_monitor::test
