// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/srdf_reader.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <set>
#include <utility>

#include "model/name_index.h"
#include "model/srdf/srdf_groups.h"
#include "model/srdf/srdf_spheres.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

/// The links of one robot by the names its SRDF uses.
class LinkLookup {
 public:
  explicit LinkLookup(const NameIndex& names) : names_(names) {}

  /// Nothing if the robot has no link of this name, which is then noted as unknown.
  std::optional<LinkId> find(const std::string& name, const XMLElement& element) {
    const std::optional<LinkId> link = names_.link(name);
    if (!link) {
      unknown_.add(quoted(name), element.GetLineNum());
      return std::nullopt;
    }
    is_any_known_ = true;
    return link;
  }

  const std::vector<std::string>& unknown() const { return unknown_.all(); }
  bool isAnyKnown() const { return is_any_known_; }

 private:
  const NameIndex& names_;
  UnknownNames unknown_;
  bool is_any_known_{false};
};

/// Checks that the SRDF is for this robot: links of other robots may have the same names.
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

/// Whether a line says what it disables.
bool isComplete(const XMLElement& element, std::initializer_list<const char*> attributes,
                UnknownNames& incomplete) {
  return std::all_of(attributes.begin(), attributes.end(), [&](const char* attribute) {
    const bool is_there =
        attributeOf(element, attribute).find_first_not_of(" \t\r\n/") != std::string::npos;
    if (!is_there) {
      incomplete.add("<" + std::string(element.Name()) + "> without " + attribute,
                     element.GetLineNum());
    }
    return is_there;
  });
}

void readPair(const XMLElement& element, const Place& place, LinkLookup& links,
              std::vector<SrdfPairs::Entry>& entries) {
  const auto name_1 = readName(element, "link1", place);
  const auto name_2 = readName(element, "link2", place);
  if (!name_1 || !name_2) {
    return;
  }
  const std::optional<LinkId> a = links.find(*name_1, element);
  const std::optional<LinkId> b = links.find(*name_2, element);
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
  entries.push_back({*a, *b, reason == nullptr ? "" : reason, element.GetLineNum()});
}

void readRule(const XMLElement& element, const Place& place, LinkLookup& links, SrdfPairs& pairs,
              UnknownNames& incomplete) {
  if (std::strcmp(element.Name(), "disable_collisions") == 0) {
    if (isComplete(element, {"link1", "link2"}, incomplete)) {
      readPair(element, place, links, pairs.disabled);
    }
  } else if (std::strcmp(element.Name(), "enable_collisions") == 0) {
    readPair(element, place, links, pairs.enabled);
  } else if (std::strcmp(element.Name(), "disable_default_collisions") == 0) {
    if (isComplete(element, {"link"}, incomplete)) {
      if (const auto link = links.find(*readName(element, "link", place), element)) {
        pairs.disabled_by_default.push_back({*link, element.GetLineNum()});
      }
    }
  }
}

/// Warns of unknown names. They can only cause more pairs to be checked.
void reportUnknown(const std::string& found, const std::string& accepted, const std::string& advice,
                   bool is_strict, const Place& place) {
  if (is_strict) {
    place.addError(0, found, accepted + " (strict)");
  } else {
    place.addWarning(0, found, advice);
  }
}

void reportUnknownLinks(const LinkLookup& links, bool is_strict, const Place& place) {
  if (!links.unknown().empty()) {
    const std::string of_another = links.isAnyKnown() ? "" : "not one of its links is known, ";
    reportUnknown(of_another + "unknown links: " + someOf(links.unknown()), "links of the URDF",
                  "the robot lacks them; lines that name them are ignored", is_strict, place);
  }
}

void reportIncomplete(const UnknownNames& incomplete, bool is_strict, const Place& place) {
  if (!incomplete.all().empty()) {
    reportUnknown("lines that name no link: " + someOf(incomplete.all()), "names of links",
                  "these lines are ignored", is_strict, place);
  }
}

void reportUnknownOfGroups(const UnknownOfGroups& unknown, bool is_strict, const Place& place) {
  const std::string accepted = "names of the URDF and of groups";
  if (!unknown.members.all().empty()) {
    reportUnknown("groups with unknown members: " + someOf(unknown.members.all()), accepted,
                  "the robot lacks them; they are left out", is_strict, place);
  }
  if (!unknown.others.all().empty()) {
    reportUnknown("other elements with unknown names: " + someOf(unknown.others.all()), accepted,
                  "the robot lacks them; no pair depends on these elements", is_strict, place);
  }
}

std::pair<LinkId, LinkId> ordered(const SrdfPairs::Entry& entry) {
  return entry.a < entry.b ? std::pair(entry.a, entry.b) : std::pair(entry.b, entry.a);
}

/// Warns of lines that contradict each other. The pair is then checked.
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
    place.addWarning(0, "pairs that are both enabled and disabled: " + someOf(both),
                     "these are checked");
  }
}

}  // namespace

SrdfPairs readSrdf(const RobotDescription& description, RobotId robot, const RobotModel& model,
                   SetupReport& report) {
  SrdfPairs pairs;
  pairs.robot = robot;
  pairs.source =
      description.srdf_source.empty() ? description.source + " (SRDF)" : description.srdf_source;
  Oddities oddities;
  const Place place(pairs.source, report, oddities);
  tinyxml2::XMLDocument document;
  const XMLElement* root = parseRobotXml(description.srdf_xml, "SRDF", place, document);
  if (root == nullptr || index(robot) >= model.robots.size()) {
    return pairs;
  }
  checkRobot(*root, model.robots[index(robot)].name, place);
  const NameIndex names(model, robot);
  LinkLookup links(names);
  UnknownNames incomplete;
  for (const XMLElement* e = root->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    readRule(*e, place, links, pairs, incomplete);
  }
  reportIncomplete(incomplete, description.is_strict, place);
  reportUnknownLinks(links, description.is_strict, place);
  UnknownOfGroups unknown;
  pairs.groups = readGroups(*root, model, names, unknown);
  pairs.spheres = readSpheres(*root, names, place);
  reportUnknownOfGroups(unknown, description.is_strict, place);
  reportContradictions(pairs, model, place);
  return pairs;
}

}  // namespace collision_monitor
