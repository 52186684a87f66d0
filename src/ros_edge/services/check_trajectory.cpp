// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/check_trajectory.h"

#include <collision_monitor/State.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "collision_monitor/geometry/ids.h"
#include "model/number_text.h"
#include "model/place.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/robots/missing.h"
#include "ros_edge/services/read_trajectory.h"

namespace collision_monitor {
namespace {

/// Limits the search to some ten seconds: a service must end.
constexpr std::uint64_t kBudget = 100'000'000;

static_assert(LinkApproach::CLEAR == static_cast<int>(ApproachState::clear) &&
              LinkApproach::CONTACT == static_cast<int>(ApproachState::contact) &&
              LinkApproach::UNDECIDED == static_cast<int>(ApproachState::undecided) &&
              LinkApproach::UNKNOWN == static_cast<int>(ApproachState::unknown));

TrajectoryOptions optionsOf(const CycleSetup& setup, const CheckTrajectory::Request& request) {
  TrajectoryOptions options;
  options.margin = request.margin;
  if (!(request.margin > 0.0)) {
    const auto warning_distance = [](const Limits& limits) { return limits.warning_distance; };
    options.margin = largestOfLimits(setup, warning_distance);
    for (const CheckedLinkPair& pair : setup.checked) {
      options.margins.push_back(warning_distance(limitsOf(setup, pair)));
    }
  }
  options.resolution = request.resolution > 0.0 ? request.resolution : options.resolution;
  options.budget = kBudget;
  return options;
}

std::vector<std::string> findFaults(const CheckTrajectory::Request& request) {
  std::vector<std::string> faults;
  if (!std::isfinite(request.margin)) {
    faults.push_back("margin is " + shortText(request.margin) +
                     "; give finite metres, or 0 for warning_distance");
  }
  if (!std::isfinite(request.resolution)) {
    faults.push_back("resolution is " + shortText(request.resolution) +
                     "; give finite metres, or 0 for 0.001");
  }
  return faults;
}

/// The first contact, then pairs by distance, then unknown ones; ties by index.
std::vector<LinkPairIndex> orderOf(const TrajectoryReport& report) {
  std::vector<LinkPairIndex> order(report.pairs.size());
  for (LinkPairIndex i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  const auto rank = [&](LinkPairIndex i) {
    const PairApproach& pair = report.pairs[i];
    const bool is_unknown = pair.state == ApproachState::unknown;
    return std::make_tuple(i != report.first_contact, is_unknown,
                           is_unknown ? 0.0 : pair.nearest.measured.distance, i);
  };
  std::sort(order.begin(), order.end(),
            [&](LinkPairIndex one, LinkPairIndex other) { return rank(one) < rank(other); });
  return order;
}

/// @param start where the trajectory begins; its parts are valid for the whole motion
void fill(const MonitorSetup& current, const LinkPoses& start, const CheckedLinkPair& links,
          const PairApproach& pair, LinkApproach& message) {
  const CycleSetup& setup = current.setup;
  message.state = static_cast<std::uint8_t>(pair.state);
  if (pair.state == ApproachState::unknown) {
    message.time = message.at_least = kUnknown;
    toUnknownMessage(setup, links.a, links.b, message.nearest);
    return;
  }
  message.time = pair.time;
  message.at_least = pair.at_least;
  if (std::isfinite(pair.nearest.measured.distance)) {
    toMessage(current, start, pair.nearest, message.nearest);
  } else {  // given up before any measurement
    toUnknownMessage(setup, links.a, links.b, message.nearest);
  }
}

std::string summaryText(const CycleSetup& setup, const TrajectoryReport& report,
                        const CheckTrajectory::Response& response) {
  const std::string unknown = response.pairs_unknown == 0
                                  ? ""
                                  : "; " + counted(response.pairs_unknown, "pair") + " unknown";
  if (report.first_contact != kNone) {
    PairApproach first = report.pairs[report.first_contact];
    double& distance = first.nearest.measured.distance;
    distance = std::abs(distance) <= TrajectoryOptions().tolerance ? 0.0 : distance;
    return "first contact after " + secondsText(first.time) + ": " +
           distanceSentence(setup, first.nearest) + unknown;
  }
  if (response.pairs.empty()) {
    return "no pair of links is checked, so nothing can be said";
  }
  const bool is_given_up =
      std::any_of(report.pairs.begin(), report.pairs.end(),
                  [](const PairApproach& pair) { return pair.state == ApproachState::undecided; });
  const LinkApproach& nearest = response.pairs.front();
  return is_given_up ? "the search was given up: no contact was found, and none excluded" + unknown
         : nearest.state == LinkApproach::CLEAR
             ? "no contact; nearest after " + secondsText(nearest.time) + ", " +
                   nearest.nearest.link_a + " " + lengthText(nearest.nearest.distance) + " from " +
                   nearest.nearest.link_b + unknown
             : "every pair of links is unknown";
}

std::string unknownStartText(const std::vector<std::string>& joints) {
  std::string text;
  for (const std::string& joint : joints) {
    text += (text.empty() ? "; the way to the first point was not checked, for it is not known "
                            "where these joints are now: "
                          : ", ") +
            joint;
  }
  return text;
}

}  // namespace

bool isTold(const TrajectoryReport& report, double margin, LinkPairIndex pair) noexcept {
  constexpr std::size_t kMostPairs = 10'000;
  const PairApproach& approach = report.pairs[pair];
  return report.pairs.size() <= kMostPairs || approach.state != ApproachState::clear ||
         approach.at_least <= margin;
}

void answerCheckTrajectory(const MonitorSetup& current, const NewestState& newest,
                           const std::function<bool(double)>& progress,
                           const CheckTrajectory::Request& request,
                           CheckTrajectory::Response& response) {
  const CycleSetup& setup = current.setup;
  JointPath path;
  LinkPoses start = newest.poses;
  std::vector<std::string> faults = findFaults(request);
  const std::vector<std::string> of_path =
      readTrajectory(setup.model, request.trajectory, path, start);
  faults.insert(faults.end(), of_path.begin(), of_path.end());
  response.success = faults.empty() ? 1 : 0;
  response.level = State::UNKNOWN;
  response.contact_time = kUnknown;
  if (!faults.empty()) {
    response.message = join(faults);
    return;
  }
  const std::vector<std::string> unknown = addWayToFirstPoint(setup.model, newest, path, start);
  TrajectoryOptions options = optionsOf(setup, request);
  options.progress = progress;
  const TrajectoryReport report = checkTrajectory(setup, path, start, options);
  for (const LinkPairIndex pair : orderOf(report)) {
    if (!response.pairs.empty() && !isTold(report, options.margin, pair)) {
      continue;
    }
    response.pairs.emplace_back();
    fill(current, start, setup.checked[pair], report.pairs[pair], response.pairs.back());
  }
  response.pairs_checked = static_cast<std::uint32_t>(report.pairs.size());
  response.pairs_unknown = static_cast<std::uint32_t>(
      std::count_if(report.pairs.begin(), report.pairs.end(),
                    [](const PairApproach& pair) { return pair.state == ApproachState::unknown; }));
  response.level = static_cast<std::uint8_t>(verdictOf(report, options));
  if (report.first_contact != kNone) {
    response.contact_time = report.pairs[report.first_contact].time;
  }
  const std::string missing = missingSentence(current);
  if (!missing.empty()) {
    response.level = std::max<std::uint8_t>(response.level, State::UNKNOWN);
  }
  const std::string floating = floatingPartsText(setup.model, start, setup.checked, newest.reasons);
  response.message = summaryText(setup, report, response) +
                     (missing.empty() ? "" : "; " + missing) +
                     (floating.empty() ? "" : "; " + floating) + unknownStartText(unknown);
}

}  // namespace collision_monitor
