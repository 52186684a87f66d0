// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/get_distances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "model/few_texts.h"
#include "model/object_links.h"
#include "model/place.h"
#include "pipeline/answers/link_distances.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/poses/apply_joints.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/robots/missing.h"
#include "ros_edge/services/ignored_pairs.h"
#include "ros_edge/services/no_such_link.h"

namespace collision_monitor {
namespace {

std::string nothingToMeasure(const std::string& place, const std::string& name) {
  return place + ": link '" + name + "' has no collision geometry; leave it out";
}

LinkSet findLinks(const CycleSetup& setup, const std::vector<std::string>& names, const char* field,
                  std::vector<std::string>& faults) {
  const RobotModel& model = setup.model;
  LinkSet links(model.links.size(), names.empty() ? 1 : 0);
  FewTexts found;
  std::unordered_set<std::string_view> unknown;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    const auto place = [&] { return field + ("[" + std::to_string(i) + "]"); };
    const auto link = model.findLink(name);
    if (!link) {
      if (unknown.insert(name).second) {
        found.add([&] { return noSuchLink(model, place(), name); });
      }
    } else if (!hasShapes(model.link(*link))) {
      found.add([&] { return nothingToMeasure(place(), name); });
    } else {
      links[index(*link)] = 1;
    }
  }
  const std::vector<std::string> texts = found.all();
  faults.insert(faults.end(), texts.begin(), texts.end());
  return links;
}

Selection selectionOf(const CycleSetup& setup, const GetDistances::Request& request,
                      std::vector<std::string>& faults) {
  return {findLinks(setup, request.links_a, "links_a", faults),
          findLinks(setup, request.links_b, "links_b", faults)};
}

/// Selects the body pairs to measure: requested, and with a known relative pose.
void selectPairs(const CycleSetup& setup, const Selection& selection, const BodyPoses& poses,
                 std::vector<PairId>& pairs) {
  pairs.clear();
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const CheckedLinkPair& links = setup.checked[setup.link_pair_of[i]];
    if (selection.has(links.a, links.b) && isJoined(poses, links.a, links.b)) {
      pairs.push_back(idAt<PairId>(i));
    }
  }
}

/// The measured distances, and the poses.
struct Scene {
  LinkPoses poses;
  LinkDistances links;
};

/// The nearest requested pair; kNone if none was measured.
LinkPairIndex closestAsked(const CycleSetup& setup, const Selection& selection,
                           const LinkDistances& links) {
  return closestOf(links, [&](LinkPairIndex i) {
    return selection.has(setup.checked[i].a, setup.checked[i].b);
  });
}

/// The reported pairs: those within the distance, and the closest.
struct Reach {
  double distance;  ///< [m]
  LinkPairIndex closest;
};

/// If no pair is within the distance, the nearest of all is searched for.
Reach measureReach(const CycleSetup& setup, const Selection& selection, double max_distance,
                   LinkDistances& links) {
  measureWithin(setup, max_distance, Asked::within, links);
  LinkPairIndex closest = closestAsked(setup, selection, links);
  if (closest != kNone && links.of(closest).measured.distance > max_distance) {
    measureWithin(setup, std::numeric_limits<double>::infinity(), Asked::nearest, links);
    closest = closestAsked(setup, selection, links);
  }
  return {max_distance, closest};
}

/// One entry per link pair, for its nearest shapes: nearest pairs first, then unknown ones.
void fillDistances(const MonitorSetup& current, const Selection& selection, const Scene& scene,
                   const Reach& reach, Distances& message) {
  const CycleSetup& setup = current.setup;
  const LinkDistances& links = scene.links;
  std::vector<LinkDistance> unknown;
  GradientRows rows(setup, scene.poses);
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    if (!selection.has(pair.a, pair.b)) {
      continue;
    }
    ++message.pairs_checked;
    if (links.nearest[i] == kNone) {
      unknown.emplace_back();
      toUnknownMessage(setup, pair.a, pair.b, unknown.back());
    } else if (i == reach.closest || links.of(i).measured.distance <= reach.distance) {
      message.pairs.emplace_back();
      toMessage(current, scene.poses, links.of(i), message.pairs.back());
      toMessage(setup, rows.of(links.of(i)), message.pairs.back());
    }
  }
  std::stable_sort(message.pairs.begin(), message.pairs.end(),
                   [](const LinkDistance& one, const LinkDistance& other) {
                     return one.distance < other.distance;
                   });
  message.closest = message.pairs.empty() ? -1 : 0;
  message.pairs_unknown = static_cast<std::uint32_t>(unknown.size());
  message.pairs.insert(message.pairs.end(), unknown.begin(), unknown.end());
}

/// "; none within 10 mm, the nearest: a is 12 mm from b"; empty if a pair is within the distance.
std::string nearestText(const CycleSetup& setup, const LinkDistances& links, const Reach& reach) {
  if (reach.closest == kNone) {
    return "";
  }
  const PairDistance& closest = links.of(reach.closest);
  return closest.measured.distance <= reach.distance
             ? ""
             : "; none within " + lengthText(reach.distance) +
                   ", the nearest: " + distanceSentence(setup, closest);
}

/// Why none of these pairs is checked. A pair that is not even ignored is a link with itself, or
/// two free objects.
std::string nothingCheckedText(const CycleSetup& setup, const Selection& selection) {
  const std::string ignored = ignoredText(setup, selection);
  const std::string objects = hasObjects(setup.model)
                                  ? "two objects only if one is attached or a rule asks for them, "
                                  : "";
  return "no pair of these links is checked; " +
         (ignored.empty() ? "a link is not checked with itself, " + objects +
                                "and no other link with collision geometry is asked for"
                          : ignored);
}

/// The text about floating parts among the requested pairs.
std::string floatingTextOf(const CycleSetup& setup, const Selection& selection,
                           const LinkPoses& poses, const std::vector<std::string>& reasons) {
  std::vector<CheckedLinkPair> asked;
  std::copy_if(setup.checked.begin(), setup.checked.end(), std::back_inserter(asked),
               [&](const CheckedLinkPair& pair) { return selection.has(pair.a, pair.b); });
  return floatingPartsText(setup.model, poses, asked, reasons);
}

std::string summaryText(const Distances& distances, const std::string& floating,
                        const std::string& ignored) {
  const std::uint32_t measured = distances.pairs_checked - distances.pairs_unknown;
  return counted(measured, "pair") + " measured, " + std::to_string(distances.pairs_unknown) +
         " unknown" + (floating.empty() ? "" : "; " + floating) +
         (ignored.empty() ? "" : "; " + ignored);
}

/// Answers for pairs that the set-up checks.
void answerChecked(const MonitorSetup& current, const NewestState& newest,
                   const GetDistances::Request& request, GetDistances::Response& response) {
  const CycleSetup& setup = current.setup;
  std::vector<std::string> faults;
  const Selection selection = selectionOf(setup, request, faults);
  if (std::isnan(request.max_distance)) {
    faults.emplace_back("max_distance is nan; give metres, or 0 for no limit");
  }
  Scene scene{newest.poses, makeLinkDistances(setup)};
  if (!request.joints.name.empty() || !request.joints.position.empty()) {
    const std::vector<std::string> joint_faults =
        applyJoints(setup.model, request.joints, "joints.name", scene.poses);
    faults.insert(faults.end(), joint_faults.begin(), joint_faults.end());
  }
  response.success = 0;
  response.distances.closest = -1;
  if (!faults.empty()) {
    response.message = join(faults);
    return;
  }
  LinkDistances& links = scene.links;
  placeAll(setup, scene.poses, links);
  selectPairs(setup, selection, links.body_poses, links.candidates);
  response.distances.header = makeHeader(scene.poses.stamp_ns, current.world_frame);
  const Reach reach = measureReach(
      setup, selection,
      request.max_distance > 0.0 ? request.max_distance : std::numeric_limits<double>::infinity(),
      links);
  fillDistances(current, selection, scene, reach, response.distances);
  response.success = response.distances.pairs_checked > 0 ? 1 : 0;
  if (response.success == 0) {
    response.message = nothingCheckedText(setup, selection);
    return;
  }
  const std::string missing = missingSentence(current);
  // With all links, many pairs are ignored; that is not worth a message.
  const bool is_explicit = !request.links_a.empty() && !request.links_b.empty();
  response.message =
      summaryText(response.distances, floatingTextOf(setup, selection, scene.poses, newest.reasons),
                  is_explicit ? ignoredText(setup, selection) : "") +
      nearestText(setup, links, reach) + (missing.empty() ? "" : "; " + missing);
}

}  // namespace

void answerGetDistances(const MonitorSetup& current, const NewestState& newest,
                        const GetDistances::Request& request, GetDistances::Response& response) {
  if (request.include_ignored == 0) {
    answerChecked(current, newest, request, response);
    return;
  }
  std::vector<std::string> faults;  // are told later
  const Selection selection = selectionOf(current.setup, request, faults);
  std::string fault;
  std::vector<LinkPair> asked = pairsOf(current.setup, selection, fault);
  if (!fault.empty()) {
    response.success = 0;
    response.distances.closest = -1;
    response.message = fault;
    return;
  }
  MonitorSetup all;
  all.setup = withPairs(current.setup, std::move(asked));
  all.world_frame = current.world_frame;
  answerChecked(all, newest, request, response);
  response.reasons = reasonsOf(current.setup, response.distances.pairs);
}

}  // namespace collision_monitor
