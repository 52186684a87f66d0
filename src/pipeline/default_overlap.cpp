// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "default_overlap.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/pipeline/run_cycle.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

BodyRows placeInDefaultPose(const CycleSetup& setup) {
  LinkPoses poses = makeLinkPoses(setup.model);
  placeLinks(setup.model, defaultPositions(setup.model),
             std::vector<Pose>(setup.model.robots.size()), poses.world_from_link);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  BodyRows rows = makeBodyPoses(setup).rows;
  placeRows(setup, poses, rows);
  return rows;
}

/// Signed distance of each checked pair of links, by LinkPairIndex.
std::vector<double> measureLinkPairs(const CycleSetup& setup) {
  std::vector<double> distances(setup.table.size());
  measureBlocks(setup.blocks, placeInDefaultPose(setup), distances);
  std::vector<double> least(setup.checked.size(), INFINITY);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    double& nearest = least[setup.link_pair_of[i]];
    nearest = std::min(nearest, distances[i]);
  }
  return least;
}

Problem overlapWarning(const RobotModel& model, const CheckedLinkPair& pair, double distance,
                       bool is_ignored) {
  const std::string millimetres = std::to_string(std::lround(-1000.0 * distance));
  return {"pair '" + model.link(pair.a).name + "' and '" + model.link(pair.b).name + "'",
          "the shapes overlap by " + millimetres + " mm in the default pose" +
              (is_ignored ? ", so the pair is ignored" : ""),
          is_ignored ? "if it can collide, give the robot an SRDF that lists the pairs to ignore"
                     : "if the links always touch, add a disable_collisions line to the SRDF"};
}

}  // namespace

void ruleDefaultOverlaps(const std::vector<SrdfPairs>& srdfs, bool ignore, CycleSetup& setup,
                         SetupReport& report) {
  listPairs(setup);
  const std::vector<double> distances = measureLinkPairs(setup);
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    const RobotId robot = setup.model.link(pair.a).robot;
    if (distances[i] >= 0.0 || robot != setup.model.link(pair.b).robot) {
      continue;
    }
    const bool has_srdf = std::any_of(srdfs.begin(), srdfs.end(),
                                      [&](const SrdfPairs& srdf) { return srdf.robot == robot; });
    const bool is_ignored = ignore && !has_srdf;
    report.warnings.push_back(overlapWarning(setup.model, pair, distances[i], is_ignored));
    if (is_ignored) {
      const auto rule = std::find_if(
          setup.link_pairs.begin(), setup.link_pairs.end(),
          [&](const LinkPair& listed) { return listed.a == pair.a && listed.b == pair.b; });
      rule->reason = PairReason::default_overlap;
    }
  }
}

}  // namespace collision_monitor
