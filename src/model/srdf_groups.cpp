// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/srdf_groups.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "model/frame_names.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

/// Reads the groups of one robot and remembers names that lead nowhere.
///
/// Source: the SRDF page of the ROS wiki (wiki.ros.org/srdf); what it leaves open, the ends of
/// chains and virtual joints, is as MoveIt's RobotModel has it.
class GroupReader {
 public:
  GroupReader(const XMLElement& root, RobotId robot, const RobotModel& model)
      : model_(model), robot_(robot) {
    for (const XMLElement* e = root.FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      if (std::strcmp(e->Name(), "group") == 0) {
        // A second group of a name adds to the first.
        elements_[attributeOf(*e, "name")].push_back(e);
      } else if (std::strcmp(e->Name(), "virtual_joint") == 0) {
        child_of_virtual_joint_[attributeOf(*e, "name")] = attributeOf(*e, "child_link");
      }
    }
  }

  std::vector<LinkId> linksOf(const std::string& group) {
    std::set<LinkId> links;
    std::set<std::string> visited;
    addGroup(group, visited, links);
    return {links.begin(), links.end()};
  }

  const std::set<std::string>& unknown() const { return unknown_; }

 private:
  /// A circle of groups holds what its members hold.
  void addGroup(const std::string& group, std::set<std::string>& visited, std::set<LinkId>& links) {
    const auto found = elements_.find(group);
    if (found == elements_.end()) {
      unknown_.insert("group " + quoted(group));
      return;
    }
    if (!visited.insert(group).second) {
      return;
    }
    for (const XMLElement* element : found->second) {
      for (const XMLElement* e = element->FirstChildElement(); e != nullptr;
           e = e->NextSiblingElement()) {
        addMember(*e, visited, links);
      }
    }
  }

  void addMember(const XMLElement& member, std::set<std::string>& visited,
                 std::set<LinkId>& links) {
    const std::string kind = member.Name();
    if (kind == "link") {
      addIfFound(findLink(attributeOf(member, "name")), links);
    } else if (kind == "joint" || kind == "passive_joint") {
      addIfFound(findChildOf(attributeOf(member, "name")), links);
    } else if (kind == "chain") {
      addChain(findLink(attributeOf(member, "base_link")),
               findLink(attributeOf(member, "tip_link")), links);
    } else if (kind == "group") {
      addGroup(attributeOf(member, "name"), visited, links);
    }
  }

  static void addIfFound(std::optional<LinkId> link, std::set<LinkId>& links) {
    if (link) {
      links.insert(*link);
    }
  }

  /// The link and its ancestors, outermost last.
  std::vector<LinkId> pathToRoot(LinkId link) const {
    std::vector<LinkId> path{link};
    while (const auto& joint = model_.link(path.back()).parent_joint) {
      path.push_back(model_.joint(*joint).parent);
    }
    return path;
  }

  void addChain(std::optional<LinkId> base, std::optional<LinkId> tip,
                std::set<LinkId>& links) const {
    if (!base || !tip) {
      return;
    }
    std::vector<LinkId> from_base = pathToRoot(*base);
    std::vector<LinkId> from_tip = pathToRoot(*tip);
    LinkId meeting = from_base.back();
    while (!from_base.empty() && !from_tip.empty() && from_base.back() == from_tip.back()) {
      meeting = from_base.back();
      from_base.pop_back();
      from_tip.pop_back();
    }
    if (!from_base.empty()) {
      links.insert(meeting);
    }
    links.insert(from_base.begin(), from_base.end());
    links.insert(from_tip.begin(), from_tip.end());
  }

  std::string fullName(const std::string& name) const {
    const std::size_t begin = std::min(name.find_first_not_of('/'), name.size());
    return prefixed(model_.robots[index(robot_)].tf_prefix, name.substr(begin));
  }

  std::optional<LinkId> findLink(const std::string& name) {
    const std::optional<LinkId> link = model_.findLink(fullName(name));
    if (!link || model_.link(*link).robot != robot_) {
      unknown_.insert("link " + quoted(name));
      return std::nullopt;
    }
    return link;
  }

  std::optional<LinkId> findChildOf(const std::string& joint_name) {
    const auto moved = child_of_virtual_joint_.find(joint_name);
    if (moved != child_of_virtual_joint_.end()) {
      return findLink(moved->second);
    }
    const std::optional<JointId> joint = model_.findJoint(fullName(joint_name));
    if (!joint || model_.link(model_.joint(*joint).child).robot != robot_) {
      unknown_.insert("joint " + quoted(joint_name));
      return std::nullopt;
    }
    return model_.joint(*joint).child;
  }

  const RobotModel& model_;
  RobotId robot_;
  std::map<std::string, std::vector<const XMLElement*>> elements_;
  std::map<std::string, std::string> child_of_virtual_joint_;
  std::set<std::string> unknown_;
};

}  // namespace

std::vector<LinkGroup> readGroups(const XMLElement& root, RobotId robot, const RobotModel& model,
                                  const Place& place) {
  GroupReader reader(root, robot, model);
  std::vector<LinkGroup> groups;
  std::set<std::string> names;
  for (const XMLElement* e = root.FirstChildElement("group"); e != nullptr;
       e = e->NextSiblingElement("group")) {
    const std::string name = attributeOf(*e, "name");
    if (names.insert(name).second) {
      groups.push_back({name, reader.linksOf(name)});
    }
  }
  if (!reader.unknown().empty()) {
    place.addWarning(0,
                     "groups with unknown members: " +
                         joined({reader.unknown().begin(), reader.unknown().end()}),
                     "the robot lacks them; they are left out");
  }
  return groups;
}

}  // namespace collision_monitor
