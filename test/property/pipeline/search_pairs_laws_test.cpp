// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/pipeline/search_pairs.h"
#include "pipeline/pair_search/joint_ranges.h"
#include "pipeline/pair_search/touch.h"
#include "support/robots/file_loader.h"

// What is said of pairs of links, held to other states than those it was found in, each measured
// alone by the plain routines.
namespace collision_monitor::test::search_pairs_laws {
namespace {

constexpr std::size_t kStates = 300;

CycleSetup setupOf(const std::string& name) {
  for (const RobotFile& robot : allRobotFiles()) {
    if (robot.name == name) {
      SetupOptions options;
      options.ignore_default_overlap = false;
      RobotDescription description = describe(robot);
      description.srdf_xml.clear();
      return buildSetup({description}, fileLoader(robot.package_root), options);
    }
  }
  throw std::runtime_error("no robot " + name);
}

Touch touchIn(LinkPairMeasures& measures, LinkPairIndex pair, const JointPositions& state) {
  const RobotModel& model = measures.setup.model;
  std::vector<Pose> links;
  placeLinks(model, state, std::vector<Pose>(model.robots.size()), links);
  return touchOf(elementDistance(measures, pair, links));
}

TEST(SearchPairsLaws, noStateSpeaksAgainstAProof_andStatesToldAreAsTold) {
  std::size_t proven = 0;
  std::size_t sometimes = 0;
  for (const char* name : {"urdf/arm6.urdf", "urdf/dual_arm.urdf", "urdf/humanoid.urdf"}) {
    SCOPED_TRACE(name);
    const CycleSetup setup = setupOf(name);
    PairSearchOptions options;
    options.states = kStates;
    options.most_cells = 500;
    const std::vector<PairFound> pairs = searchPairs(setup, options);
    LinkPairMeasures measures(setup);
    const std::vector<JointRange> ranges = jointRanges(setup.model);
    std::mt19937_64 random(20260101);
    for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
      const PairFound& pair =
          *std::find_if(pairs.begin(), pairs.end(), [&](const PairFound& found) {
            return found.a == setup.checked[i].a && found.b == setup.checked[i].b;
          });
      if (pair.finding == PairFinding::sometimes) {
        ASSERT_EQ(touchIn(measures, i, pair.touching), Touch::touching);
        ++sometimes;
      } else if (pair.finding == PairFinding::never && pair.is_proven) {
        for (std::size_t state = 0; state < kStates; ++state) {
          ASSERT_EQ(touchIn(measures, i, drawState(setup.model, ranges, random)), Touch::apart);
        }
        ++proven;
      }
    }
  }
  EXPECT_GT(proven, 20U);
  EXPECT_GT(sometimes, 20U);
}

}  // namespace
}  // namespace collision_monitor::test::search_pairs_laws
