// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/srdf/srdf_groups.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

/// Reads the groups of one robot and collects unknown names.
///
/// Source: the SRDF page of the ROS wiki (wiki.ros.org/srdf). It does not define the ends of chains
/// and virtual joints; there this follows MoveIt's RobotModel.
class GroupReader {
 public:
  GroupReader(const XMLElement& root, const RobotModel& model, const NameIndex& names,
              UnknownOfGroups& unknown)
      : model_(model), names_(names), unknown_(unknown) {
    for (const XMLElement* e = root.FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      if (std::strcmp(e->Name(), "group") == 0) {
        // A second group with the same name adds to the first.
        const std::string name = attributeOf(*e, "name");
        if (index_of_.emplace(name, groups_.size()).second) {
          groups_.push_back({name, {}, {}, {}});
        }
      } else if (std::strcmp(e->Name(), "virtual_joint") == 0) {
        child_of_virtual_joint_[attributeOf(*e, "name")] = attributeOf(*e, "child_link");
      }
    }
  }

  void readMembers(const XMLElement& group) {
    LinkGroup& into = groups_[index_of_.at(attributeOf(group, "name"))];
    for (const XMLElement* e = group.FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      readMember(*e, into);
    }
  }

  /// Checks names in elements that are not groups.
  void checkNames(const XMLElement& element) {
    const std::string kind = element.Name();
    if (kind == "virtual_joint") {
      checkName(element, "child_link", Kind::link);
    } else if (kind == "end_effector") {
      checkName(element, "parent_link", Kind::link);
      checkName(element, "group", Kind::group);
      checkName(element, "parent_group", Kind::group);
    } else if (kind == "passive_joint") {
      checkName(element, "name", Kind::joint);
    } else if (kind == "link_sphere_approximation") {
      checkName(element, "link", Kind::link);
    } else if (kind == "group_state") {
      checkName(element, "group", Kind::group);
      for (const XMLElement* e = element.FirstChildElement("joint"); e != nullptr;
           e = e->NextSiblingElement("joint")) {
        checkName(*e, "name", Kind::joint);
      }
    }
  }

  std::vector<LinkGroup> take() { return std::move(groups_); }

 private:
  enum class Kind : unsigned char { link, joint, group };

  bool isKnown(const std::string& name, Kind kind) const {
    switch (kind) {
      case Kind::link:
        return names_.link(withoutSlashes(name)).has_value();
      case Kind::joint:
        return child_of_virtual_joint_.count(name) != 0 ||
               names_.joint(withoutSlashes(name)).has_value();
      case Kind::group:
        break;
    }
    return index_of_.count(name) != 0;
  }

  /// A missing attribute names nothing.
  void checkName(const XMLElement& element, const char* attribute, Kind kind) {
    static constexpr const char* kWords[] = {"link ", "joint ", "group "};
    const char* name = element.Attribute(attribute);
    if (name != nullptr && !isKnown(name, kind)) {
      unknown_.others.add(kWords[static_cast<std::size_t>(kind)] + quoted(name),
                          element.GetLineNum());
    }
  }

  void readMember(const XMLElement& member, LinkGroup& group) {
    const std::string kind = member.Name();
    if (kind == "link") {
      addIfFound(findLink(member, "name"), group);
    } else if (kind == "joint" || kind == "passive_joint") {
      addIfFound(findChildOf(member), group);
    } else if (kind == "chain") {
      const std::optional<LinkId> base = findLink(member, "base_link");
      const std::optional<LinkId> tip = findLink(member, "tip_link");
      if (base && tip) {
        group.chains.push_back({*base, *tip});
      }
    } else if (kind == "group") {
      const auto found = index_of_.find(attributeOf(member, "name"));
      if (found == index_of_.end()) {
        unknown_.members.add("group " + quoted(attributeOf(member, "name")), member.GetLineNum());
      } else {
        group.groups.push_back(found->second);
      }
    }
  }

  static void addIfFound(std::optional<LinkId> link, LinkGroup& group) {
    if (link) {
      group.links.push_back(*link);
    }
  }

  static std::string withoutSlashes(const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('/'), name.size()));
  }

  std::optional<LinkId> findLinkNamed(const std::string& name, int line) {
    const std::optional<LinkId> link = names_.link(withoutSlashes(name));
    if (!link) {
      unknown_.members.add("link " + quoted(name), line);
      return std::nullopt;
    }
    return link;
  }

  std::optional<LinkId> findLink(const XMLElement& member, const char* attribute) {
    return findLinkNamed(attributeOf(member, attribute), member.GetLineNum());
  }

  std::optional<LinkId> findChildOf(const XMLElement& member) {
    const std::string name = attributeOf(member, "name");
    const auto moved = child_of_virtual_joint_.find(name);
    if (moved != child_of_virtual_joint_.end()) {
      return findLinkNamed(moved->second, member.GetLineNum());
    }
    const std::optional<JointId> joint = names_.joint(withoutSlashes(name));
    if (!joint) {
      unknown_.members.add("joint " + quoted(name), member.GetLineNum());
      return std::nullopt;
    }
    return model_.joint(*joint).child;
  }

  const RobotModel& model_;
  const NameIndex& names_;
  UnknownOfGroups& unknown_;
  std::vector<LinkGroup> groups_;
  std::map<std::string, std::size_t> index_of_;
  std::map<std::string, std::string> child_of_virtual_joint_;
};

/// The link and its ancestors; the root comes last.
std::vector<LinkId> pathToRoot(const RobotModel& model, LinkId link) {
  std::vector<LinkId> path{link};
  while (const auto& joint = model.link(path.back()).parent_joint) {
    path.push_back(model.joint(*joint).parent);
  }
  return path;
}

void addChain(const RobotModel& model, const LinkGroup::Chain& chain, std::vector<LinkId>& links) {
  std::vector<LinkId> from_base = pathToRoot(model, chain.base);
  std::vector<LinkId> from_tip = pathToRoot(model, chain.tip);
  LinkId meeting = from_base.back();
  while (!from_base.empty() && !from_tip.empty() && from_base.back() == from_tip.back()) {
    meeting = from_base.back();
    from_base.pop_back();
    from_tip.pop_back();
  }
  if (!from_base.empty()) {
    links.push_back(meeting);
  }
  links.insert(links.end(), from_base.begin(), from_base.end());
  links.insert(links.end(), from_tip.begin(), from_tip.end());
}

}  // namespace

std::vector<LinkGroup> readGroups(const XMLElement& root, const RobotModel& model,
                                  const NameIndex& names, UnknownOfGroups& unknown) {
  GroupReader reader(root, model, names, unknown);
  for (const XMLElement* e = root.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (std::strcmp(e->Name(), "group") == 0) {
      reader.readMembers(*e);
    } else {
      reader.checkNames(*e);
    }
  }
  return reader.take();
}

std::vector<LinkId> linksOf(const std::vector<LinkGroup>& groups, std::size_t group,
                            const RobotModel& model) {
  std::vector<LinkId> links;
  std::vector<bool> is_visited(groups.size(), false);
  std::vector<std::size_t> to_visit{group};  // no recursion: groups may nest 20,000 deep
  is_visited[group] = true;
  while (!to_visit.empty()) {
    const LinkGroup& next = groups[to_visit.back()];
    to_visit.pop_back();
    links.insert(links.end(), next.links.begin(), next.links.end());
    for (const LinkGroup::Chain& chain : next.chains) {
      addChain(model, chain, links);
    }
    for (const std::size_t inner : next.groups) {
      if (!is_visited[inner]) {
        is_visited[inner] = true;
        to_visit.push_back(inner);
      }
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

}  // namespace collision_monitor
