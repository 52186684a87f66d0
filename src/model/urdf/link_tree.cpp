// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/urdf/link_tree.h"

#include <algorithm>
#include <map>
#include <utility>

namespace collision_monitor {
namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

using IndexByName = std::map<std::string, std::size_t>;

IndexByName indexLinks(const UrdfRobot& robot, const Place& place) {
  IndexByName index_of;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const UrdfLink& link = robot.links[i];
    const auto [first, is_new] = index_of.emplace(link.name, i);
    if (!is_new) {
      place.addError(link.line,
                     "a second link " + quoted(link.name) + ", the first is in line " +
                         std::to_string(robot.links[first->second].line),
                     "a name of its own for every link");
    }
  }
  return index_of;
}

void checkJointNames(const UrdfRobot& robot, const Place& place) {
  IndexByName index_of;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    const auto [first, is_new] = index_of.emplace(joint.joint.name, i);
    if (!is_new) {
      place.addError(joint.line,
                     "a second joint " + quoted(joint.joint.name) + ", the first is in line " +
                         std::to_string(robot.joints[first->second].line),
                     "a name of its own for every joint");
    }
  }
}

/// Index of the link that a joint names. kNowhere after an error if there is none; an empty name
/// was reported when it was read.
std::size_t findEnd(const IndexByName& index_of, const std::string& name, const UrdfJoint& joint,
                    const Place& place) {
  const auto found = index_of.find(name);
  if (found != index_of.end()) {
    return found->second;
  }
  if (!name.empty()) {
    place.within("joint " + quoted(joint.joint.name))
        .addError(joint.line, "unknown link " + quoted(name), "the name of a <link> of this robot");
  }
  return kNowhere;
}

/// Joints above and below each link, by link index.
struct Connections {
  std::vector<std::size_t> parent_joints;  ///< kNowhere for a root
  std::vector<std::vector<std::size_t>> child_joints;
  std::vector<std::size_t> child_of_joint;
  bool is_broken{false};
};

Connections connect(const UrdfRobot& robot, const Place& place) {
  Connections connections;
  connections.parent_joints.assign(robot.links.size(), kNowhere);
  connections.child_joints.resize(robot.links.size());
  connections.child_of_joint.assign(robot.joints.size(), kNowhere);
  const IndexByName index_of = indexLinks(robot, place);
  connections.is_broken = index_of.size() != robot.links.size();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    const std::size_t parent = findEnd(index_of, joint.parent, joint, place);
    const std::size_t child = findEnd(index_of, joint.child, joint, place);
    if (parent == kNowhere || child == kNowhere) {
      connections.is_broken = true;
      continue;
    }
    std::size_t& parent_joint = connections.parent_joints[child];
    if (parent_joint != kNowhere) {
      place.within("link " + quoted(joint.child))
          .addError(joint.line,
                    "a second parent by joint " + quoted(joint.joint.name) + ", the first is by " +
                        quoted(robot.joints[parent_joint].joint.name) + " in line " +
                        std::to_string(robot.joints[parent_joint].line),
                    "one joint that has this link as its child");
      connections.is_broken = true;
      continue;
    }
    parent_joint = i;
    connections.child_joints[parent].push_back(i);
    connections.child_of_joint[i] = child;
  }
  return connections;
}

/// The only root; kNowhere after an error if there is none or several.
std::size_t findRoot(const UrdfRobot& robot, const Connections& connections, const Place& place) {
  std::vector<std::string> names;
  std::size_t root = kNowhere;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (connections.parent_joints[i] == kNowhere) {
      root = i;
      names.push_back(quoted(robot.links[i].name));
    }
  }
  if (names.size() == 1) {
    return root;
  }
  if (names.empty()) {
    place.addError(0, "no root link: the joints form a loop",
                   "one link that no joint has as child");
  } else {
    place.addError(0, std::to_string(names.size()) + " root links: " + joined(names),
                   "one link that no joint has as child; join the others to it, by fixed joints if "
                   "they do not move");
  }
  return kNowhere;
}

LinkTree walk(const Connections& connections, const UrdfRobot& robot, std::size_t root) {
  LinkTree tree;
  // An explicit stack: chains may be deeper than the call stack allows.
  struct Visit {
    std::size_t joint;
    std::size_t parent;
  };
  std::vector<Visit> open;
  const auto enter = [&](std::size_t link) {
    const std::size_t position = tree.links.size();
    tree.links.push_back(link);
    const auto& joints = connections.child_joints[link];
    for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
      open.push_back({*joint, position});
    }
  };
  tree.links.reserve(robot.links.size());
  enter(root);
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    tree.joints.push_back(visit.joint);
    tree.parents.push_back(visit.parent);
    enter(connections.child_of_joint[visit.joint]);
  }
  return tree;
}

void reportLoops(const UrdfRobot& robot, const LinkTree& tree, const Place& place) {
  std::vector<bool> is_reached(robot.links.size(), false);
  for (const std::size_t link : tree.links) {
    is_reached[link] = true;
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!is_reached[i]) {
      names.push_back(quoted(robot.links[i].name));
    }
  }
  place.addError(
      0, "links that hang on a loop of joints: " + joined(names),
      "a tree: every link reached from the root " + quoted(robot.links[tree.links.front()].name));
}

}  // namespace

std::optional<LinkTree> sortLinks(const UrdfRobot& robot, const Place& place) {
  checkJointNames(robot, place);
  if (robot.links.empty()) {
    place.addError(0, "no links", "at least one <link>");
    return std::nullopt;
  }
  const Connections connections = connect(robot, place);
  if (connections.is_broken) {
    return std::nullopt;  // faults of roots and loops would only follow from these
  }
  const std::size_t root = findRoot(robot, connections, place);
  if (root == kNowhere) {
    return std::nullopt;
  }
  LinkTree tree = walk(connections, robot, root);
  if (tree.links.size() != robot.links.size()) {
    reportLoops(robot, tree, place);
    return std::nullopt;
  }
  return tree;
}

}  // namespace collision_monitor
