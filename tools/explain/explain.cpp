// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <limits>

#include "collision_monitor/model/kinematics.h"
#include "explain_options.h"
#include "explain_setup.h"
#include "model/nearest_name.h"
#include "model/number_text.h"
#include "model/object_links.h"
#include "model/place.h"
#include "pipeline/answers/link_distances.h"
#include "pipeline/answers/pair_reason.h"

/// Explains a pair of links: `explain --help`.
namespace collision_monitor::explain_tool {
namespace {

constexpr int kDone = 0;
constexpr int kInputFault = 1;

std::optional<LinkId> findLink(const RobotModel& model, const std::string& name,
                               SetupReport& report) {
  const std::optional<LinkId> link = model.findLink(name);
  if (!link) {
    std::vector<std::string> known;
    for (const Link& one : model.links) {
      known.push_back(one.name);
    }
    report.errors.push_back({"link " + quoted(name), "unknown" + suggestion(name, known),
                             "links and objects: " + someOf(known)});
  } else if (!hasShapes(model.link(*link))) {
    report.errors.push_back(
        {"link " + quoted(name), "without collision geometry", "links with geometry"});
  }
  return link;
}

/// Tells of positions that the joint does not reach. @pre the joint exists
void warnOfLimits(const Joint& joint, double position) {
  if (position < joint.lower || position > joint.upper) {
    std::fprintf(stderr, "warning: joint '%s' does not reach %s, but %s to %s\n",
                 joint.name.c_str(), shortText(position).c_str(), shortText(joint.lower).c_str(),
                 shortText(joint.upper).c_str());
  }
}

/// Moves the joints that the user names.
void readJoints(const RobotModel& model, const std::vector<std::string>& joints,
                JointPositions& positions, SetupReport& report) {
  for (const std::string& text : joints) {
    const std::size_t sign = text.rfind('=');
    const std::string name = text.substr(0, sign);
    const std::optional<JointId> joint = model.findJoint(name);
    Eigen::VectorXd position(1);
    const bool is_number =
        sign != std::string::npos && !parseNumbers(text.substr(sign + 1), position);
    const bool moves = joint && !model.joint(*joint).mimic &&
                       (model.joint(*joint).type == JointType::revolute ||
                        model.joint(*joint).type == JointType::continuous ||
                        model.joint(*joint).type == JointType::prismatic);
    if (!is_number || !moves) {
      report.errors.push_back(
          {"option --joint", quoted(text),
           "NAME=POSITION of a joint that turns or slides and mimics no other"});
      continue;
    }
    positions[model.joint(*joint).first_variable] = position[0];
    warnOfLimits(model.joint(*joint), position[0]);
  }
}

/// What a monitor would say of links at rest.
void printVerdict(const CycleSetup& setup, const LinkPair& pair, const PairDistance& nearest) {
  if (!isChecked(pair.reason)) {
    std::printf("verdict   none, since they are ignored\n");
    return;
  }
  const Limits& limits = limitsOf(setup, pair);
  const bool is_contact = isTouching(nearest, limits.contact_distance);
  const bool is_warning = nearest.measured.distance <= limits.warning_distance;
  std::printf("verdict   %s: %s %s, %s m\n",
              is_contact   ? "CONTACT"
              : is_warning ? "WARNING"
                           : "OK",
              is_contact || is_warning ? "at most" : "more than",
              is_contact ? "contact_distance" : "warning_distance",
              shortText(is_contact ? limits.contact_distance : limits.warning_distance).c_str());
}

/// Measures the pair alone.
void printDistance(const CycleSetup& setup, std::size_t place, const JointPositions& positions) {
  std::vector<bool> is_wanted(setup.link_pairs.size(), false);
  is_wanted[place] = true;
  const CycleSetup alone = withPairs(setup, is_wanted);
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
  printVerdict(setup, setup.link_pairs[place], nearest);
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
  const CycleSetup setup = makeSetup(options);
  SetupReport report;
  const auto a = findLink(setup.model, options.link_a, report);
  const auto b = findLink(setup.model, options.link_b, report);
  JointPositions positions = defaultPositions(setup.model);
  readJoints(setup.model, options.joints, positions, report);
  throwIfErrors(report);
  const std::size_t place = findLinkPair(setup, *a, *b);
  if (place == setup.link_pairs.size()) {
    report.errors.push_back({"links " + quoted(options.link_a) + " and " + quoted(options.link_b),
                             "no pair", "two links, or two objects for which a rule asks"});
    throwIfErrors(report);
  }
  const LinkPair& pair = setup.link_pairs[place];
  std::printf("%s and %s are %s\n", nameInText(setup.model, pair.a).c_str(),
              nameInText(setup.model, pair.b).c_str(), reasonOf(setup, pair).c_str());
  printDistance(setup, place, positions);
  std::printf("limits\n");
  printLimits(setup, pair);
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
