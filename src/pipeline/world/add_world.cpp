// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/add_world.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "geometry/interruption.h"
#include "pipeline/setup/memory_need.h"
#include "pipeline/setup/setup_parts.h"

namespace collision_monitor {
namespace {

/// An object and the link that it becomes.
struct ObjectLink {
  LinkId link{};
  const WorldObject* object{nullptr};
};

/// Adds links of objects to a set-up.
class LinkAdder {
 public:
  LinkAdder(const WorldOptions& options, const PreparedObjects& prepared, CycleSetup& setup)
      : options_(options), prepared_(prepared), setup_(setup) {
    for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
      names_.emplace(setup.model.links[i].name, idAt<LinkId>(i));
      frames_.emplace(setup.model.links[i].frame, idAt<LinkId>(i));
    }
  }

  /// @return the links of all objects, in order of id
  std::vector<ObjectLink> add(const World& world) {
    std::vector<std::pair<LinkId, const WorldObject*>> of_links;
    std::map<std::string, std::vector<const WorldObject*>> of_frames;
    for (const auto& [name, object] : world.objects) {
      if (const auto link = carrierOf(*object)) {
        of_links.emplace_back(*link, object.get());
      } else {
        of_frames[frameOf(*object)].push_back(object.get());
      }
    }
    for (const auto& [frame, objects] : of_frames) {
      startRobot(frame);
      const LinkId carrier = addLink(frame, frame);
      setup_.model.robots.back().root = carrier;
      for (const WorldObject* object : objects) {
        addObject(*object, carrier);
      }
    }
    if (!of_links.empty()) {
      // Objects of one link stand together, since they move together.
      std::stable_sort(of_links.begin(), of_links.end(),
                       [](const auto& one, const auto& other) { return one.first < other.first; });
      startRobot("objects");
      setup_.model.robots.back().root = idAt<LinkId>(setup_.model.links.size());
      for (const auto& [link, object] : of_links) {
        addObject(*object, link);
      }
    }
    return std::move(added_);
  }

 private:
  const std::string& frameOf(const WorldObject& object) const {
    return object.frame.empty() ? options_.world_frame : object.frame;
  }

  /// The link that carries an object; none: a tf frame does.
  std::optional<LinkId> carrierOf(const WorldObject& object) const {
    const auto& places = object.is_attached ? names_ : frames_;
    const auto place = places.find(object.is_attached ? object.frame : frameOf(object));
    return place == places.end() ? std::nullopt : std::optional<LinkId>(place->second);
  }

  void startRobot(const std::string& name) {
    Robot robot;
    robot.name = name;
    robot.first_link = setup_.model.links.size();
    robot.first_joint = setup_.model.joints.size();
    robot.is_world = true;
    setup_.model.robots.push_back(robot);
  }

  LinkId addLink(const std::string& name, const std::string& frame) {
    Link link;
    link.name = name;
    link.frame = frame;
    link.robot = idAt<RobotId>(setup_.model.robots.size() - 1);
    setup_.model.links.push_back(std::move(link));
    ++setup_.model.robots.back().link_count;
    return idAt<LinkId>(setup_.model.links.size() - 1);
  }

  void addObject(const WorldObject& object, LinkId carrier) {
    const LinkId link = addLink(object.name, object.name);
    Joint joint;
    joint.name = object.name;
    joint.parent = carrier;
    joint.child = link;
    joint.parent_from_joint = object.frame_from_object;
    joint.first_variable = setup_.model.variable_count;
    setup_.model.links.back().parent_joint = idAt<JointId>(setup_.model.joints.size());
    setup_.model.links.back().has_given_shapes = true;
    setup_.model.joints.push_back(std::move(joint));
    ++setup_.model.robots.back().joint_count;
    addShapes(*prepared_.at(object.name), link);
    added_.push_back({link, &object});
  }

  void addShapes(const PreparedObject& shapes, LinkId link) {
    const std::size_t first = setup_.elements.size();
    for (Body body : shapes.bodies) {
      body.link = link;
      body.element = idAt<ElementId>(first + index(body.element));
      setup_.bodies.push_back(body);
    }
    setup_.labels.insert(setup_.labels.end(), shapes.labels.begin(), shapes.labels.end());
    for (const Element& element : shapes.elements) {
      setup_.elements.push_back(element);
      setup_.elements.back().link = link;
    }
  }

  const WorldOptions& options_;
  const PreparedObjects& prepared_;
  CycleSetup& setup_;
  std::unordered_map<std::string, LinkId> names_;
  std::unordered_map<std::string, LinkId> frames_;
  std::vector<ObjectLink> added_;
};

/// By LinkId: the first link of those that only fixed joints join. Parents come before children.
std::vector<LinkId> rigidGroups(const RobotModel& model) {
  std::vector<LinkId> group_of(model.links.size());
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& joint = model.links[i].parent_joint;
    const bool is_fixed = joint && model.joint(*joint).type == JointType::fixed;
    group_of[i] = is_fixed ? group_of[index(model.joint(*joint).parent)] : idAt<LinkId>(i);
  }
  return group_of;
}

/// A pair that no rule has decided.
LinkPair pairOf(LinkId a, LinkId b, PairReason reason) {
  LinkPair pair{a, b};
  pair.reason = pair.without_rules = reason;
  return pair;
}

/// The groups of objects, for rules.
SrdfPairs groupsOf(const std::vector<ObjectLink>& objects, const RobotModel& model) {
  std::map<std::string, std::vector<LinkId>> links;
  for (const ObjectLink& object : objects) {
    if (!object.object->group.empty()) {
      links[object.object->group].push_back(object.link);
    }
  }
  SrdfPairs groups;
  groups.source = "objects";
  groups.robot = model.link(objects.front().link).robot;
  for (auto& [name, of_group] : links) {
    groups.groups.push_back({name, std::move(of_group), {}, {}});
  }
  return groups;
}

/// Decides the pairs of objects.
class PairAdder {
 public:
  PairAdder(const RobotModel& model, const std::vector<ObjectLink>& objects)
      : model_(model), objects_(objects), group_of_(rigidGroups(model)) {
    for (const ObjectLink& object : objects) {
      touch_links_.emplace_back(object.object->touch_links.begin(),
                                object.object->touch_links.end());
    }
  }

  /// Merges pairs of objects into those of robots, sorted by (a, b).
  void add(std::vector<LinkPair>& pairs) const {
    std::vector<LinkPair> merged;
    merged.reserve(pairs.size() + model_.links.size() * objects_.size());
    auto next = pairs.begin();
    const std::size_t robot_links = index(objects_.front().link);
    for (std::size_t i = 0; i < robot_links; ++i) {
      throwIfInterrupted();
      const LinkId link = idAt<LinkId>(i);
      for (; next != pairs.end() && next->a == link; ++next) {
        merged.push_back(*next);
      }
      if (hasShapes(model_.link(link))) {
        for (std::size_t k = 0; k < objects_.size(); ++k) {
          merged.push_back(pairOf(link, objects_[k].link, reasonFor(link, k)));
        }
      }
    }
    addObjectPairs(merged);
    pairs = std::move(merged);
  }

 private:
  PairReason reasonFor(LinkId link, std::size_t k) const {
    const ObjectLink& object = objects_[k];
    if (object.object->is_attached && group_of_[index(link)] == group_of_[index(object.link)]) {
      return PairReason::same_rigid_group;
    }
    return touch_links_[k].count(model_.link(link).name) != 0 ? PairReason::touch_link
                                                              : PairReason::checked;
  }

  /// Pairs that no attached object is in are left out: they may be a million.
  void addObjectPairs(std::vector<LinkPair>& pairs) const {
    std::vector<std::size_t> attached;
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      if (objects_[k].object->is_attached) {
        attached.push_back(k);
      }
    }
    for (std::size_t i = 0; i < objects_.size() && !attached.empty(); ++i) {
      if (objects_[i].object->is_attached) {
        for (std::size_t k = i + 1; k < objects_.size(); ++k) {
          addObjectPair(i, k, pairs);
        }
        continue;
      }
      for (auto k = std::upper_bound(attached.begin(), attached.end(), i); k != attached.end();
           ++k) {
        addObjectPair(i, *k, pairs);
      }
    }
  }

  void addObjectPair(std::size_t i, std::size_t k, std::vector<LinkPair>& pairs) const {
    const LinkId a = objects_[i].link;
    const LinkId b = objects_[k].link;
    const bool move_together = group_of_[index(a)] == group_of_[index(b)];
    pairs.push_back(
        pairOf(a, b, move_together ? PairReason::same_rigid_group : PairReason::checked));
  }

  const RobotModel& model_;
  const std::vector<ObjectLink>& objects_;
  std::vector<LinkId> group_of_;
  std::vector<std::set<std::string>> touch_links_;  ///< by object
};

/// Robots without a pair of their own have pairs with objects.
void dropWarningOfNoPairs(CycleSetup& setup) {
  std::vector<Problem>& warnings = setup.report.warnings;
  const auto is_dropped = [](const Problem& warning) { return warning.where == kPairsWarning; };
  if (!setup.checked.empty()) {
    warnings.erase(std::remove_if(warnings.begin(), warnings.end(), is_dropped), warnings.end());
  }
}

}  // namespace

CycleSetup addWorld(const CycleSetup& robots, const World& world, const PreparedObjects& prepared,
                    const WorldOptions& options) {
  if (world.objects.empty()) {
    return robots;
  }
  CycleSetup setup;
  setup.model = robots.model;
  setup.bodies = robots.bodies;
  setup.labels = robots.labels;
  setup.elements = robots.elements;
  setup.link_pairs = robots.link_pairs;
  setup.limits = robots.limits;
  setup.own_limits = robots.own_limits;
  setup.refine = robots.refine;
  setup.is_continuous = robots.is_continuous;
  setup.ahead = robots.ahead;
  setup.velocity_names = robots.velocity_names;
  setup.srdfs = robots.srdfs;
  setup.pair_rules = robots.pair_rules;
  setup.report = robots.report;
  const std::vector<ObjectLink> objects = LinkAdder(options, prepared, setup).add(world);
  setup.srdfs.push_back(groupsOf(objects, setup.model));
  PairAdder(setup.model, objects).add(setup.link_pairs);
  SetupReport report;
  checkMemory(countPairs(setup), options.memory_limit, report);
  throwIfErrors(report);
  listPairs(setup);
  if (robots.checked.empty()) {
    dropWarningOfNoPairs(setup);
  }
  return setup;
}

}  // namespace collision_monitor
