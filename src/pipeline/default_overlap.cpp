// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "default_overlap.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/prove_apart.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

std::string overlapText(const PairDistance& distance) {
  const long millimetres = std::lround(1e3 * distance.measured.distance);
  if (touchOf(distance) == Touch::apart) {
    return "padding makes them overlap; the geometries are at least " +
           std::to_string(millimetres) + " mm apart";
  }
  const std::string by = " overlap by " + std::to_string(-millimetres) + " mm";
  switch (distance.quality) {
    case Quality::exact:
      return "the geometries" + by;
    case Quality::estimate:
      return "the geometries overlap";
    default:
      return "the enclosing shapes" + by;
  }
}

Problem overlapWarning(const RobotModel& model, const CheckedLinkPair& pair,
                       const PairDistance& distance, bool is_ignored) {
  return {"pair '" + model.link(pair.a).name + "' and '" + model.link(pair.b).name + "'",
          overlapText(distance) + " in the default pose" +
              (is_ignored ? ", so the pair is ignored" : ""),
          is_ignored ? "if it can collide, give the robot an SRDF that lists the pairs to ignore"
                     : "if the links always touch, add a disable_collisions line to the SRDF"};
}

/// What was added to the shapes of each link. Units: metres.
std::vector<double> paddingsOf(const std::vector<LinkFit>& fits, std::size_t link_count) {
  std::vector<double> paddings(link_count, 0.0);
  for (const LinkFit& fit : fits) {
    paddings[index(fit.link)] = fit.padding;
  }
  return paddings;
}

}  // namespace

void ruleDefaultOverlaps(const std::vector<SrdfPairs>& srdfs, const std::vector<LinkFit>& fits,
                         bool ignore, CycleSetup& setup, SetupReport& report) {
  listPairs(setup);
  LinkPairMeasures measures(setup);
  const std::vector<Pose> world_from_link = defaultPoses(setup.model);
  const std::vector<double> paddings = paddingsOf(fits, setup.model.links.size());
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    const RobotId robot = setup.model.link(pair.a).robot;
    if (robot != setup.model.link(pair.b).robot ||
        bodyDistance(measures, i, world_from_link).measured.distance > 0.0) {
      continue;
    }
    PairDistance distance = elementDistance(measures, i, world_from_link);
    if (touchOf(distance) == Touch::apart) {
      continue;
    }
    distance.measured.distance += paddings[index(pair.a)] + paddings[index(pair.b)];
    const bool has_srdf = std::any_of(srdfs.begin(), srdfs.end(),
                                      [&](const SrdfPairs& srdf) { return srdf.robot == robot; });
    const bool is_ignored = ignore && !has_srdf && touchOf(distance) != Touch::apart;
    report.warnings.push_back(overlapWarning(setup.model, pair, distance, is_ignored));
    if (is_ignored) {
      const auto rule = std::find_if(
          setup.link_pairs.begin(), setup.link_pairs.end(),
          [&](const LinkPair& listed) { return listed.a == pair.a && listed.b == pair.b; });
      rule->reason = PairReason::default_overlap;
    }
  }
}

}  // namespace collision_monitor
