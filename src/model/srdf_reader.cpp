// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/srdf_reader.h"

#include <cstring>
#include <set>
#include <utility>

#include "model/frame_names.h"
#include "model/srdf_groups.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

/// The links of one robot by the names its SRDF uses.
class LinkLookup {
 public:
  LinkLookup(RobotId robot, const RobotModel& model) : robot_(robot), model_(model) {}

  /// Nothing, remembered as unknown, for a name that is no link of the robot.
  std::optional<LinkId> find(const std::string& name) {
    const std::string full_name = prefixed(model_.robots[index(robot_)].tf_prefix, name);
    const std::optional<LinkId> link = model_.findLink(full_name);
    if (!link || model_.link(*link).robot != robot_) {
      if (is_unknown_.insert(name).second) {
        unknown_.push_back(quoted(name));
      }
      return std::nullopt;
    }
    ++known_count_;
    return link;
  }

  const std::vector<std::string>& unknown() const { return unknown_; }
  std::size_t knownCount() const { return known_count_; }

 private:
  RobotId robot_;
  const RobotModel& model_;
  std::set<std::string> is_unknown_;
  std::vector<std::string> unknown_;  ///< in the order of the file
  std::size_t known_count_{0};
};

/// Whether this is what it is taken for: links of other robots may have the same names.
void checkRobot(const XMLElement& root, const std::string& urdf_name, const Place& place) {
  const char* name = root.Attribute("name");
  if (name != nullptr && name != urdf_name) {
    place.addWarning(root.GetLineNum(), "robot name " + quoted(name),
                     "the URDF's is " + quoted(urdf_name) + "; it is read all the same");
  }
  if (const XMLElement* link = root.FirstChildElement("link")) {
    place.addError(link->GetLineNum(), "<link>, as in a URDF", "an SRDF");
  }
}

void readPair(const XMLElement& element, const Place& place, LinkLookup& links,
              std::vector<SrdfPairs::Entry>& entries) {
  const auto name_1 = readName(element, "link1", place);
  const auto name_2 = readName(element, "link2", place);
  if (!name_1 || !name_2) {
    return;
  }
  const std::optional<LinkId> a = links.find(*name_1);
  const std::optional<LinkId> b = links.find(*name_2);
  if (!a || !b) {
    return;
  }
  if (*a == *b) {
    place.addWarning(element.GetLineNum(),
                     "<" + std::string(element.Name()) + "> of " + quoted(*name_1) + " with itself",
                     "the line is ignored");
    return;
  }
  const char* reason = element.Attribute("reason");
  entries.push_back({*a, *b, reason == nullptr ? "" : reason});
}

void readRule(const XMLElement& element, const Place& place, LinkLookup& links, SrdfPairs& pairs) {
  if (std::strcmp(element.Name(), "disable_collisions") == 0) {
    readPair(element, place, links, pairs.disabled);
  } else if (std::strcmp(element.Name(), "enable_collisions") == 0) {
    readPair(element, place, links, pairs.enabled);
  } else if (std::strcmp(element.Name(), "disable_default_collisions") == 0) {
    if (const auto name = readName(element, "link", place)) {
      if (const auto link = links.find(*name)) {
        pairs.disabled_by_default.push_back(*link);
      }
    }
  }
}

void reportUnknownLinks(const LinkLookup& links, const Place& place) {
  if (links.unknown().empty()) {
    return;
  }
  const std::string found = "unknown links: " + joined(links.unknown());
  if (links.knownCount() == 0) {
    place.addError(0, found, "the SRDF of this robot; not one of its links is named");
  } else {
    place.addWarning(0, found, "the robot lacks them; lines that name them are ignored");
  }
}

std::pair<LinkId, LinkId> ordered(const SrdfPairs::Entry& entry) {
  return entry.a < entry.b ? std::pair(entry.a, entry.b) : std::pair(entry.b, entry.a);
}

/// Two lines that say the opposite: the pair is checked, and somebody should know.
void reportContradictions(const SrdfPairs& pairs, const RobotModel& model, const Place& place) {
  std::set<std::pair<LinkId, LinkId>> disabled;
  for (const SrdfPairs::Entry& entry : pairs.disabled) {
    disabled.insert(ordered(entry));
  }
  std::vector<std::string> both;
  for (const SrdfPairs::Entry& entry : pairs.enabled) {
    if (disabled.count(ordered(entry)) != 0) {
      both.push_back(quoted(model.link(entry.a).name) + " - " + quoted(model.link(entry.b).name));
    }
  }
  if (!both.empty()) {
    place.addWarning(0, "pairs that are both enabled and disabled: " + joined(both),
                     "these are checked");
  }
}

}  // namespace

SrdfPairs readSrdf(const RobotDescription& description, RobotId robot, const RobotModel& model,
                   SetupReport& report) {
  SrdfPairs pairs;
  pairs.robot = robot;
  Oddities oddities;
  const Place place(description.source + " (SRDF)", report, oddities);
  tinyxml2::XMLDocument document;
  const XMLElement* root = parseRobotXml(description.srdf_xml, "SRDF", place, document);
  if (root == nullptr || index(robot) >= model.robots.size()) {
    return pairs;
  }
  checkRobot(*root, model.robots[index(robot)].name, place);
  LinkLookup links(robot, model);
  for (const XMLElement* e = root->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    readRule(*e, place, links, pairs);
  }
  reportUnknownLinks(links, place);
  pairs.groups = readGroups(*root, robot, model, place);
  reportContradictions(pairs, model, place);
  return pairs;
}

}  // namespace collision_monitor
