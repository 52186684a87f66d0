// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "default_overlap.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "collision_monitor/model/kinematics.h"
#include "geometry/interruption.h"
#include "pipeline/pair_search/touch.h"
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

/// Pairs of one robot that become ignored, or that stay checked.
struct Overlaps {
  std::size_t count{0};
  std::string pairs;
};

void add(const RobotModel& model, const CheckedLinkPair& pair, const PairDistance& distance,
         Overlaps& overlaps) {
  ++overlaps.count;
  overlaps.pairs += (overlaps.pairs.empty() ? "" : "; ") + ("'" + model.link(pair.a).name) +
                    "' and '" + model.link(pair.b).name + "' (" + overlapText(distance) + ")";
}

/// Adds one warning for all pairs: a robot without SRDF may have dozens.
void warnOf(const Overlaps& overlaps, const std::string& robot, bool are_ignored,
            SetupReport& report) {
  if (overlaps.count == 0) {
    return;
  }
  const bool is_one = overlaps.count == 1;
  const std::string found = std::to_string(overlaps.count) + (is_one ? " pair" : " pairs") +
                            " of links that overlap" + (is_one ? "s" : "") +
                            " in the default pose " + (is_one ? "is " : "are ") +
                            (are_ignored ? "not checked: " : "checked: ") + overlaps.pairs;
  report.warnings.push_back(
      {"robot '" + robot + "'", found, "",
       are_ignored ? "if one of them can part, `rosrun collision_monitor pairs` tells, and writes "
                     "an SRDF; with an SRDF only pairs that it names are left out"
                   : "what always touches is left out by disable_collisions in the SRDF, or by the "
                     "parameter ignore_pairs"});
}

/// A robot's SRDF decides which of its pairs are ignored.
bool hasSrdf(const std::vector<SrdfPairs>& srdfs, RobotId robot) {
  return std::any_of(srdfs.begin(), srdfs.end(),
                     [&](const SrdfPairs& srdf) { return srdf.robot == robot; });
}

/// Notes that a pair overlaps in the default pose.
/// @return whether it becomes ignored: a rule that checks it stays in force
bool ignoreUnlessRuled(const CheckedLinkPair& pair, std::vector<LinkPair>& pairs) {
  const auto listed = std::lower_bound(
      pairs.begin(), pairs.end(), pair, [](const LinkPair& one, const CheckedLinkPair& wanted) {
        return std::tie(one.a, one.b) < std::tie(wanted.a, wanted.b);
      });
  listed->without_rules = PairReason::default_overlap;
  if (listed->rule != kNone) {
    return false;
  }
  listed->reason = PairReason::default_overlap;
  return true;
}

/// [m] The padding of the shapes of each link.
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
  std::vector<Overlaps> ignored(setup.model.robots.size());
  std::vector<Overlaps> kept(setup.model.robots.size());
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    throwIfInterrupted();
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
    const bool overlaps = ignore && !hasSrdf(srdfs, robot) && touchOf(distance) != Touch::apart;
    const bool is_ignored = overlaps && ignoreUnlessRuled(pair, setup.link_pairs);
    add(setup.model, pair, distance, (is_ignored ? ignored : kept)[index(robot)]);
  }
  for (std::size_t i = 0; i < setup.model.robots.size(); ++i) {
    warnOf(ignored[i], setup.model.robots[i].name, true, report);
    warnOf(kept[i], setup.model.robots[i].name, false, report);
  }
}

}  // namespace collision_monitor
