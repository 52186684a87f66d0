// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <limits>
#include <tuple>

#include "collision_monitor/model/kinematics.h"
#include "explain_options.h"
#include "explain_setup.h"
#include "model/number_text.h"
#include "model/object_links.h"
#include "model/rules/rigid_groups.h"
#include "pipeline/answers/link_distances.h"
#include "pipeline/answers/pair_reason.h"

/// Explains a pair of links: `explain --help`.
namespace collision_monitor::explain_tool {
namespace {

constexpr int kDone = 0;
constexpr int kInputFault = 1;

/// What a monitor would say of links at rest.
void printVerdict(const CycleSetup& setup, const LinkPair& pair, const PairDistance& nearest) {
  if (!isChecked(pair.reason)) {
    std::printf("verdict   none, since they are ignored\n");
    return;
  }
  const Limits& limits = limitsOf(setup, pair);
  const bool is_contact = isTouching(nearest, limits.contact_distance);
  const bool is_warning = nearest.measured.distance <= limits.warning_distance;
  if (nearest.quality == Quality::estimate) {
    std::printf("verdict   CONTACT: their geometries overlap\n");
    return;
  }
  std::printf("verdict   %s: %s %s, %s m\n",
              is_contact   ? "CONTACT"
              : is_warning ? "WARNING"
                           : "OK",
              is_contact || is_warning ? "at most" : "more than",
              is_contact ? "contact_distance" : "warning_distance",
              shortText(is_contact ? limits.contact_distance : limits.warning_distance).c_str());
}

/// Measures the pair alone.
void printDistance(const CycleSetup& setup, const LinkPair& pair, const JointPositions& positions) {
  const CycleSetup alone = withPairs(setup, {pair});
  LinkPoses poses = makeLinkPoses(alone.model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  placeLinks(alone.model, positions, std::vector<Pose>(alone.model.robots.size()),
             poses.world_from_link);
  LinkDistances links = makeLinkDistances(alone);
  placeAll(alone, poses, links);
  for (std::size_t i = 0; i < alone.table.size(); ++i) {
    links.candidates.push_back(idAt<PairId>(i));
  }
  measureWithin(alone, std::numeric_limits<double>::infinity(), Asked::nearest, links);
  const PairDistance& nearest = links.of(0);
  const BodyPair& bodies = alone.table[nearest.pair];
  const auto shape = [&](BodyId body) {
    return nearest.is_refined ? alone.elements[index(alone.bodies[index(body)].element)].name
                              : alone.labels[index(body)].shape_name;
  };
  const char* const quality = nearest.quality == Quality::exact      ? "exact"
                              : nearest.quality == Quality::estimate ? "an estimate of the depth"
                                                                     : "a lower bound";
  std::printf("distance  %s m, %s; between %s and %s\n",
              shortText(nearest.measured.distance).c_str(), quality, shape(bodies.a).c_str(),
              shape(bodies.b).c_str());
  printVerdict(setup, pair, nearest);
}

void printLimits(const CycleSetup& setup, const LinkPair& pair) {
  const Limits& limits = limitsOf(setup, pair);
  const std::vector<std::string> places = limitPlaces(setup, pair);
  for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
    const LimitField& field = kLimitFields[i];
    std::printf("  %-16s  %s%s%s\n", field.name, shortText(limits.*field.value).c_str(), field.unit,
                places[i].empty() ? "" : ("  (" + places[i] + ")").c_str());
  }
}

int run(const Options& options) {
  const Explained explained = makeSetup(options);
  const CycleSetup& setup = explained.setup;
  const LinkId a = *setup.model.findLink(options.link_a);
  const LinkId b = *setup.model.findLink(options.link_b);
  const std::size_t place = findLinkPair(setup, a, b);
  const bool is_pair = place < setup.link_pairs.size();
  LinkPair pair;
  std::tie(pair.a, pair.b) = std::minmax(a, b);
  pair.reason = PairReason::two_objects;
  pair = is_pair ? setup.link_pairs[place] : pair;
  std::printf("%s and %s are %s\n", nameInText(setup.model, pair.a).c_str(),
              nameInText(setup.model, pair.b).c_str(),
              is_pair ? reasonOf(setup, pair).c_str()
                      : reasonOfObjects(findRigidGroups(setup.model), a, b).c_str());
  printDistance(setup, pair, explained.positions);
  if (is_pair) {
    std::printf("limits\n");
    printLimits(setup, pair);
  }
  return kDone;
}

}  // namespace
}  // namespace collision_monitor::explain_tool

int main(int argc, char** argv) {
  using namespace collision_monitor::explain_tool;
  try {
    const Parsed parsed = parseOptions(argc, argv);
    return parsed.is_to_run ? run(parsed.options) : parsed.exit_code;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "explain: %s\n", collision_monitor::failureText(fault).c_str());
    return kInputFault;
  }
}
