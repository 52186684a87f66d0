// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/explain_pair.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/number_text.h"
#include "model/object_links.h"
#include "model/rules/rigid_groups.h"
#include "pipeline/answers/link_distances.h"
#include "pipeline/answers/pair_reason.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/services/no_such_link.h"

namespace collision_monitor {
namespace {

/// Nothing, after a fault, if there is no such link with shapes.
std::optional<LinkId> findLink(const RobotModel& model, const char* field, const std::string& name,
                               std::vector<std::string>& faults) {
  const std::optional<LinkId> link = model.findLink(name);
  if (!link) {
    faults.push_back(noSuchLink(model, field, name));
  } else if (!hasShapes(model.link(*link))) {
    faults.push_back(std::string(field) + ": link '" + name +
                     "' has no collision geometry, so it is in no pair");
  }
  return link;
}

void fillLimits(const CycleSetup& setup, const LinkPair& pair, ExplainPair::Response& response) {
  const Limits& limits = limitsOf(setup, pair);
  const std::vector<std::string> places = limitPlaces(setup, pair);
  for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
    response.limit_names.emplace_back(kLimitFields[i].name);
    response.limit_values.push_back(limits.*kLimitFields[i].value);
    response.limit_places.push_back(places[i].empty() ? "limits" : places[i]);
  }
}

/// Measures this pair alone. @return a sentence
std::string fillNow(const MonitorSetup& current, const NewestState& newest, const LinkPair& asked,
                    LinkDistance& message) {
  MonitorSetup alone;
  alone.setup = withPairs(current.setup, {asked});
  alone.world_frame = current.world_frame;
  const CycleSetup& setup = alone.setup;
  const CheckedLinkPair& pair = setup.checked.front();
  LinkDistances links = makeLinkDistances(setup);
  placeAll(setup, newest.poses, links);
  if (!isJoined(links.body_poses, pair.a, pair.b)) {
    toUnknownMessage(setup, pair.a, pair.b, message);
    return "the distance is not known: the links have no known relative pose";
  }
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    links.candidates.push_back(idAt<PairId>(i));
  }
  measureWithin(setup, std::numeric_limits<double>::infinity(), Asked::nearest, links);
  toMessage(alone, newest.poses, links.of(0), message);
  return "now " + distanceSentence(setup, links.of(0)) + " (" + message.shape_a + ", " +
         message.shape_b + ")";
}

/// @return a sentence
std::string fillNearest(const CycleSetup& setup, const PairView& view, double farthest,
                        ExplainPair::Response& response) {
  if (!std::isfinite(view.nearest.distance)) {
    return "since start no cycle has found them nearer than " + lengthText(farthest);
  }
  response.nearest = view.nearest.distance;
  response.nearest_quality = static_cast<std::uint8_t>(view.nearest.quality);
  response.nearest_stamp.fromNSec(static_cast<std::uint64_t>(view.nearest.stamp_ns));
  std::string joints;
  for (const Joint& joint : setup.model.joints) {
    const bool is_one = joint.type == JointType::revolute || joint.type == JointType::continuous ||
                        joint.type == JointType::prismatic;
    if (is_one && !joint.mimic && joint.first_variable < view.positions.size() &&
        std::isfinite(view.positions[joint.first_variable])) {
      response.nearest_joints.push_back(joint.name);
      response.nearest_positions.push_back(view.positions[joint.first_variable]);
      joints += (joints.empty() ? "" : ", ") + joint.name + " " +
                fixedText(view.positions[joint.first_variable], 3);
    }
  }
  const double distance = view.nearest.distance;
  const bool is_bound = view.nearest.quality == Quality::lower_bound;
  const std::string at = view.nearest.quality == Quality::exact ? ""
                         : is_bound && distance < 0.0           ? "at most "
                                                                : "at least ";
  return "nearest since start: " + std::string(distance < 0.0 ? "overlapping by " : "") + at +
         lengthText(distance) + (joints.empty() ? "" : " at " + joints);
}

}  // namespace

void answerExplainPair(const MonitorSetup& current, const NewestState& newest,
                       const PairViewer& view, const ExplainPair::Request& request,
                       ExplainPair::Response& response) {
  const CycleSetup& setup = current.setup;
  std::vector<std::string> faults;
  const auto a = findLink(setup.model, "link_a", request.link_a, faults);
  const auto b = findLink(setup.model, "link_b", request.link_b, faults);
  if (a && b && *a == *b) {
    faults.emplace_back("link_a and link_b are the same; a link is not checked with itself");
  }
  response.success = 0;
  response.nearest = kUnknown;
  response.nearest_quality = LinkDistance::UNKNOWN;
  toUnknownMessage(response.now);
  if (!faults.empty()) {
    response.message = join(faults);
    return;
  }
  const std::size_t place = findLinkPair(setup, *a, *b);
  response.success = 1;
  if (place == setup.link_pairs.size()) {
    LinkPair objects;
    std::tie(objects.a, objects.b) = std::minmax(*a, *b);
    objects.reason = PairReason::two_objects;
    response.reason = reasonOfObjects(findRigidGroups(setup.model), *a, *b);
    response.message = join({nameInText(setup.model, objects.a) + " and " +
                                 nameInText(setup.model, objects.b) + " are " + response.reason,
                             fillNow(current, newest, objects, response.now)});
    return;
  }
  const LinkPair& pair = setup.link_pairs[place];
  response.checked = isChecked(pair.reason) ? 1 : 0;
  response.reason = reasonOf(setup, pair);
  fillLimits(setup, pair, response);
  std::vector<std::string> sentences{nameInText(setup.model, pair.a) + " and " +
                                         nameInText(setup.model, pair.b) + " are " +
                                         response.reason,
                                     fillNow(current, newest, pair, response.now)};
  const std::optional<PairView> seen = view(request.link_a, request.link_b);
  if (!seen) {
    sentences.emplace_back("the cycle did not answer, so its verdict is not known");
    response.level = static_cast<std::uint8_t>(Verdict::unknown);
  } else if (seen->is_checked) {
    response.level = static_cast<std::uint8_t>(seen->verdict);
    response.level_reason = seen->why;
    sentences.push_back(std::string(verdictName(seen->verdict)) + ": " + seen->why);
    sentences.push_back(fillNearest(setup, *seen, limitsOf(setup, pair).report_distance, response));
  }
  response.message = join(sentences);
}

}  // namespace collision_monitor
