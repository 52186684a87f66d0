// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/urdf_reader.h"

#include <map>
#include <utility>

#include "model/frame_names.h"
#include "model/urdf/link_tree.h"
#include "model/urdf/urdf_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

/// One URDF without faults, ready to be added to the model.
struct ReadRobot {
  UrdfRobot robot;
  LinkTree tree;
  std::vector<std::optional<ResolvedMimic>> mimics;
};

/// @return nothing if its links are not known; after other faults what could be read
std::optional<ReadRobot> readRobot(const RobotDescription& description, MeshStore& store,
                                   SetupReport& report) {
  Oddities oddities;
  const Place place(description.source, report, oddities);
  tinyxml2::XMLDocument document;
  const tinyxml2::XMLElement* root = parseRobotXml(description.urdf_xml, "URDF", place, document);
  if (root == nullptr) {
    return std::nullopt;
  }
  ReadRobot read;
  read.robot = readUrdfRobot(*root, {store, description}, place);
  std::optional<LinkTree> tree = sortLinks(read.robot, place);
  read.mimics = resolveMimics(read.robot, place);
  reportOddities(description.source, oddities, report);
  if (!tree) {
    return std::nullopt;
  }
  read.tree = std::move(*tree);
  return read;
}

std::size_t variableCount(JointType type) {
  switch (type) {
    case JointType::fixed:
      return 0;
    case JointType::revolute:
    case JointType::continuous:
    case JointType::prismatic:
      return 1;
    case JointType::planar:
      return 3;
    case JointType::floating:
      return 7;
  }
  return 0;
}

void appendLinks(ReadRobot& read, Robot& robot, RobotModel& model) {
  robot.first_link = model.links.size();
  robot.link_count = read.tree.links.size();
  robot.root = idAt<LinkId>(robot.first_link);
  const RobotId id = idAt<RobotId>(model.robots.size());
  for (std::size_t i = 0; i < read.tree.links.size(); ++i) {
    UrdfLink& source = read.robot.links[read.tree.links[i]];
    Link link;
    link.name = prefixed(robot.tf_prefix, source.name);
    link.frame = source.is_absolute_frame ? source.name : link.name;
    link.robot = id;
    if (i > 0) {
      link.parent_joint = idAt<JointId>(model.joints.size() + i - 1);
    }
    link.collisions = std::move(source.collisions);
    model.links.push_back(std::move(link));
  }
}

void appendJoints(const ReadRobot& read, Robot& robot, RobotModel& model) {
  robot.first_joint = model.joints.size();
  robot.joint_count = read.tree.joints.size();
  std::vector<JointId> id_of(read.robot.joints.size());
  for (std::size_t i = 0; i < read.tree.joints.size(); ++i) {
    const std::size_t source = read.tree.joints[i];
    id_of[source] = idAt<JointId>(robot.first_joint + i);
    Joint joint = read.robot.joints[source].joint;
    joint.name = prefixed(robot.tf_prefix, joint.name);
    joint.parent = idAt<LinkId>(robot.first_link + read.tree.parents[i]);
    joint.child = idAt<LinkId>(robot.first_link + i + 1);
    joint.first_variable = model.variable_count;
    if (!read.mimics[source]) {
      model.variable_count += variableCount(joint.type);
    }
    model.joints.push_back(std::move(joint));
  }
  // Only now every source has its variable: a source may come after its followers.
  for (std::size_t i = 0; i < read.tree.joints.size(); ++i) {
    if (const auto& mimic = read.mimics[read.tree.joints[i]]) {
      Joint& joint = model.joints[robot.first_joint + i];
      joint.mimic = Mimic{id_of[mimic->source], mimic->multiplier, mimic->offset};
      joint.first_variable = model.joint(joint.mimic->source).first_variable;
    }
  }
}

void appendRobot(ReadRobot read, const std::string& tf_prefix, RobotModel& model) {
  Robot robot;
  robot.name = read.robot.name;
  robot.tf_prefix = trimmedPrefix(tf_prefix);
  appendLinks(read, robot, model);
  appendJoints(read, robot, model);
  model.robots.push_back(std::move(robot));
}

/// Which link or joint has which name.
class NameOwners {
 public:
  /// @param what "link"
  NameOwners(std::string what, const std::vector<RobotDescription>& descriptions,
             SetupReport& report)
      : what_(std::move(what)), descriptions_(descriptions), report_(report) {}

  /// @param id index of the link or joint
  /// @return false after an error if another one has the name.
  bool take(const std::string& name, RobotId robot, std::size_t id) {
    const auto [first, is_new] = owner_of_.emplace(name, Owner{robot, id});
    if (is_new || first->second.id == id) {
      return true;
    }
    const bool is_of_robot = first->second.robot == robot;
    report_.errors.push_back({sourceOf(robot),
                              what_ + " " + quoted(name) + " is also a" +
                                  (is_of_robot ? "nother " : " ") + what_ + " of " +
                                  sourceOf(first->second.robot),
                              is_of_robot ? "names that differ with their tf prefix, too"
                                          : "a tf prefix for each robot, so that names differ"});
    return false;
  }

 private:
  struct Owner {
    RobotId robot;
    std::size_t id;
  };

  const std::string& sourceOf(RobotId robot) const { return descriptions_[index(robot)].source; }

  std::string what_;
  const std::vector<RobotDescription>& descriptions_;
  SetupReport& report_;
  std::map<std::string, Owner> owner_of_;
};

/// Links are identified only by name in messages and tf, and moving joints in messages and
/// services. So names must differ.
void checkNamesDiffer(const std::vector<RobotDescription>& descriptions, const RobotModel& model,
                      SetupReport& report) {
  NameOwners links("link", descriptions, report);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    for (const std::string& name : {link.name, link.frame}) {
      if (!links.take(name, link.robot, i)) {
        break;
      }
    }
  }
  NameOwners joints("joint", descriptions, report);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.type != JointType::fixed) {
      joints.take(joint.name, model.link(joint.child).robot, i);
    }
  }
}

}  // namespace

RobotModel readLinks(const std::vector<RobotDescription>& descriptions,
                     const ResourceLoader& load_resource, SetupReport& report,
                     const MeshReading& reading) {
  const std::size_t errors_before = report.errors.size();
  MeshStore store(load_resource, reading);
  RobotModel model;
  for (const RobotDescription& description : descriptions) {
    if (auto read = readRobot(description, store, report)) {
      appendRobot(std::move(*read), description.tf_prefix, model);
    } else {
      report.awaits_names = true;
    }
  }
  if (report.errors.size() == errors_before) {
    checkNamesDiffer(descriptions, model, report);
  }
  return model;
}

RobotModel readRobots(const std::vector<RobotDescription>& descriptions,
                      const ResourceLoader& load_resource, SetupReport& report,
                      const MeshReading& reading) {
  const std::size_t errors_before = report.errors.size();
  RobotModel model = readLinks(descriptions, load_resource, report, reading);
  // Part of a model must not pass for the whole: missing robots collide with nothing.
  return report.errors.size() == errors_before ? model : RobotModel{};
}

}  // namespace collision_monitor
