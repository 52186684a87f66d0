// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/add_world.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "pipeline/setup/setup_parts.h"
#include "pipeline/world/object_pairs.h"
#include "pipeline/world/order_objects.h"

namespace collision_monitor {
namespace {

/// Adds links of objects to a set-up.
class LinkAdder {
 public:
  LinkAdder(const std::string& world_frame, const PreparedObjects& prepared, CycleSetup& setup)
      : world_frame_(world_frame), prepared_(prepared), setup_(setup) {
    for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
      names_.emplace(setup.model.links[i].name, idAt<LinkId>(i));
      frames_.emplace(setup.model.links[i].frame, idAt<LinkId>(i));
    }
  }

  /// @return the links of all objects, in order of id
  std::vector<ObjectLink> add(const World& world) {
    std::map<LinkId, std::vector<const WorldObject*>> of_links;  // which move together
    std::map<std::string, std::vector<const WorldObject*>> of_frames;
    for (const auto& [name, object] : world.objects) {
      if (const auto link = carrierOf(*object)) {
        of_links[*link].push_back(object.get());
      } else {
        of_frames[frameOf(*object)].push_back(object.get());
      }
    }
    for (auto& [frame, objects] : of_frames) {
      orderByPlace(objects);
      startRobot(frame);
      const LinkId carrier = addLink(frame, frame);
      setup_.model.robots.back().root = carrier;
      for (const WorldObject* object : objects) {
        addObject(*object, carrier);
      }
    }
    if (!of_links.empty()) {
      startRobot("objects");
      setup_.model.robots.back().root = idAt<LinkId>(setup_.model.links.size());
      for (auto& [link, objects] : of_links) {
        orderByPlace(objects);
        for (const WorldObject* object : objects) {
          addObject(*object, link);
        }
      }
    }
    return std::move(added_);
  }

 private:
  const std::string& frameOf(const WorldObject& object) const {
    return object.frame.empty() ? world_frame_ : object.frame;
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

  const std::string& world_frame_;
  const PreparedObjects& prepared_;
  CycleSetup& setup_;
  std::unordered_map<std::string, LinkId> names_;
  std::unordered_map<std::string, LinkId> frames_;
  std::vector<ObjectLink> added_;
};

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

/// Robots without a pair of their own have pairs with objects.
void dropWarningOfNoPairs(CycleSetup& setup) {
  std::vector<Problem>& warnings = setup.report.warnings;
  const auto is_dropped = [](const Problem& warning) { return warning.where == kPairsWarning; };
  if (!setup.checked.empty()) {
    warnings.erase(std::remove_if(warnings.begin(), warnings.end(), is_dropped), warnings.end());
  }
}

/// The model without triangles of meshes, which are large: elements and bodies stand for them.
RobotModel withoutMeshes(const RobotModel& model) {
  RobotModel copy;
  copy.robots = model.robots;
  copy.joints = model.joints;
  copy.variable_count = model.variable_count;
  for (const Link& link : model.links) {
    copy.links.push_back(
        {link.name, link.frame, link.robot, link.parent_joint, {}, link.has_given_shapes});
    for (const CollisionElement& element : link.collisions) {
      const bool is_mesh = std::holds_alternative<TriangleMesh>(element.geometry);
      copy.links.back().collisions.push_back({element.name, element.link_from_geometry,
                                              is_mesh ? TriangleMesh() : element.geometry,
                                              element.mesh_name, element.mesh_scale});
    }
  }
  return copy;
}

}  // namespace

CycleSetup withoutPairs(const CycleSetup& robots) {
  return withoutTables(robots, withoutMeshes(robots.model));
}

CycleSetup addWorld(const CycleSetup& robots, const World& world, const PreparedObjects& prepared,
                    const std::string& world_frame) {
  CycleSetup setup = withoutPairs(robots);
  if (world.objects.empty()) {
    listPairs(setup);
    return setup;
  }
  const std::vector<ObjectLink> objects = LinkAdder(world_frame, prepared, setup).add(world);
  setup.srdfs.push_back(groupsOf(objects, setup.model));
  const ObjectPairs pairs(setup, objects);
  const PairCounts counts = pairs.count();
  SetupReport report;
  checkMemory(counts, setup.memory_limit, report);
  throwIfErrors(report);
  setup.link_pairs = pairs.merged(counts.link_pairs);
  listPairs(setup);
  dropWarningOfNoPairs(setup);
  return setup;
}

void applyRulesText(const DocumentText& text, IdleRule idle, CycleSetup& setup) {
  SetupReport report;
  const std::vector<PairRule> rules = readPairRules(text, setup.model, setup.srdfs, idle, report);
  if (idle == IdleRule::is_error) {
    reportIdleRules(rules, withAskedPairs(setup, rules, report), idle, report);
  }
  throwIfErrors(report);
  if (!rules.empty()) {
    setup = withPairRules(setup, setup.limits, rules, report);
  }
  std::vector<Problem>& warnings = setup.report.warnings;
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
}

}  // namespace collision_monitor
