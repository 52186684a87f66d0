// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/second_reader/compare_readings.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "model/joint_type_names.h"
#include "model/name_index.h"
#include "model/place.h"

namespace collision_monitor {
namespace {

JointType typeOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return JointType::revolute;
    case urdf::Joint::CONTINUOUS:
      return JointType::continuous;
    case urdf::Joint::PRISMATIC:
      return JointType::prismatic;
    case urdf::Joint::FLOATING:
      return JointType::floating;
    case urdf::Joint::PLANAR:
      return JointType::planar;
    default:
      return JointType::fixed;
  }
}

/// A mimic joint's relation to the joint at the end of its chain.
struct FollowedMimic {
  const urdf::Joint* source{nullptr};  ///< none: the joint moves by itself
  double multiplier{1.0};
  double offset{0.0};
};

/// The movable joint that `joint` follows directly; none if there is no such joint.
const urdf::Joint* sourceOf(const urdf::ModelInterface& model, const urdf::Joint& joint) {
  if (!joint.mimic || typeOf(joint) == JointType::fixed) {
    return nullptr;
  }
  const auto found = model.joints_.find(joint.mimic->joint_name);
  return found == model.joints_.end() || typeOf(*found->second) == JointType::fixed
             ? nullptr
             : found->second.get();
}

FollowedMimic followMimics(const urdf::ModelInterface& model, const urdf::Joint& joint) {
  FollowedMimic followed;
  const urdf::Joint* at = &joint;
  for (std::size_t steps = 0; steps <= model.joints_.size(); ++steps) {
    const urdf::Joint* source = sourceOf(model, *at);
    if (source == nullptr) {
      break;
    }
    followed.offset += followed.multiplier * at->mimic->offset;
    followed.multiplier *= at->mimic->multiplier;
    followed.source = at = source;
  }
  return followed;
}

std::string mimicText(const std::string& source, double multiplier, double offset) {
  return "mimic of " + quoted(source) + " by " + numberText(multiplier) + " and " +
         numberText(offset);
}

/// Compares two readings of one robot.
class RobotComparison {
 public:
  RobotComparison(const RobotModel& model, RobotId robot, const urdf::ModelInterface& theirs,
                  Differences& differences)
      : ours_(model),
        robot_(model.robots[index(robot)]),
        names_(model, robot),
        theirs_(theirs),
        differences_(differences) {}

  void compareLinks() {
    std::set<std::size_t> seen;
    for (const auto& [name, link] : theirs_.links_) {
      const std::optional<LinkId> found = names_.link(plainName(name));
      if (!found) {
        differences_.add("link " + quoted(name), "no link", "a link");
        continue;
      }
      seen.insert(index(*found));
      compareShapes("link " + quoted(name), ours_.link(*found).collisions, link->collision_array,
                    differences_);
    }
    for (std::size_t i = 0; i < robot_.link_count; ++i) {
      if (seen.count(robot_.first_link + i) == 0) {
        differences_.add("link " + quoted(ours_.links[robot_.first_link + i].name), "a link",
                         "no link");
      }
    }
  }

  void compareJoints() {
    std::set<std::size_t> seen;
    for (const auto& [name, joint] : theirs_.joints_) {
      const std::optional<JointId> found = names_.joint(plainName(name));
      if (!found) {
        differences_.add("joint " + quoted(name), "no joint", "a joint");
        continue;
      }
      seen.insert(index(*found));
      compareJoint("joint " + quoted(name), ours_.joint(*found), *joint);
    }
    for (std::size_t i = 0; i < robot_.joint_count; ++i) {
      if (seen.count(robot_.first_joint + i) == 0) {
        differences_.add("joint " + quoted(ours_.joints[robot_.first_joint + i].name), "a joint",
                         "no joint");
      }
    }
  }

 private:
  void compareJoint(const std::string& element, const Joint& ours, const urdf::Joint& theirs) {
    if (ours.type != typeOf(theirs)) {
      differences_.add(element, std::string("type ") + nameOf(ours.type),
                       std::string("type ") + nameOf(typeOf(theirs)));
      return;  // further differences would only follow from this one
    }
    compareEnd(element, "parent", ours.parent, theirs.parent_link_name);
    compareEnd(element, "child", ours.child, theirs.child_link_name);
    const urdf::Pose& origin = theirs.parent_to_joint_origin_transform;
    if (!areSame(ours.parent_from_joint, origin)) {
      differences_.add(element, "origin " + poseText(ours.parent_from_joint),
                       "origin " + poseText(poseOf(origin)));
    }
    compareAxes(element, ours, theirs);
    compareLimits(element, ours, theirs);
    compareMimics(element, ours, theirs);
  }

  void compareEnd(const std::string& element, const char* end, LinkId ours,
                  const std::string& theirs) {
    if (names_.link(plainName(theirs)) != ours) {
      differences_.add(element, std::string(end) + " " + quoted(ours_.link(ours).name),
                       std::string(end) + " " + quoted(theirs));
    }
  }

  void compareAxes(const std::string& element, const Joint& ours, const urdf::Joint& theirs) {
    constexpr double kTolerance = 1e-9;
    const bool has_axis = ours.type != JointType::fixed && ours.type != JointType::floating;
    const Eigen::Vector3d axis = vectorOf(theirs.axis);
    // Written so that NaN counts as a difference.
    if (has_axis && !((ours.axis - axis.stableNormalized()).norm() <= kTolerance)) {
      differences_.add(element, "axis " + vectorText(ours.axis), "axis " + vectorText(axis));
    }
  }

  void compareLimit(const std::string& element, const char* name, double ours, double theirs) {
    if (!areSame(ours, theirs) && std::abs(theirs) <= kFarthest) {
      differences_.add(element, std::string(name) + " " + numberText(ours),
                       std::string(name) + " " + numberText(theirs));
    }
  }

  void compareLimits(const std::string& element, const Joint& ours, const urdf::Joint& theirs) {
    if (!theirs.limits) {
      return;
    }
    if (ours.type == JointType::revolute || ours.type == JointType::prismatic) {
      compareLimit(element, "lower limit", ours.lower, theirs.limits->lower);
      compareLimit(element, "upper limit", ours.upper, theirs.limits->upper);
    }
    if (ours.type != JointType::fixed && theirs.limits->velocity > 0.0) {
      compareLimit(element, "velocity limit", ours.max_velocity, theirs.limits->velocity);
    }
  }

  void compareMimics(const std::string& element, const Joint& ours, const urdf::Joint& theirs) {
    const FollowedMimic followed = followMimics(theirs_, theirs);
    const bool is_same =
        followed.source == nullptr
            ? !ours.mimic
            : ours.mimic && names_.joint(plainName(followed.source->name)) == ours.mimic->source &&
                  areSame(ours.mimic->multiplier, followed.multiplier) &&
                  areSame(ours.mimic->offset, followed.offset);
    if (!is_same) {
      differences_.add(element,
                       ours.mimic ? mimicText(ours_.joint(ours.mimic->source).name,
                                              ours.mimic->multiplier, ours.mimic->offset)
                                  : "no mimic",
                       followed.source != nullptr
                           ? mimicText(followed.source->name, followed.multiplier, followed.offset)
                           : "no mimic");
    }
  }

  const RobotModel& ours_;
  const Robot& robot_;
  NameIndex names_;
  const urdf::ModelInterface& theirs_;
  Differences& differences_;
};

}  // namespace

Differences::Differences(std::string source, std::vector<Problem>& problems)
    : source_(std::move(source)), problems_(problems) {}

void compareReadings(const std::string& source, const RobotModel& model, RobotId robot,
                     const urdf::ModelInterface& theirs, std::vector<Problem>& problems) {
  Differences differences(source, problems);
  RobotComparison comparison(model, robot, theirs, differences);
  comparison.compareLinks();
  comparison.compareJoints();
  differences.tellHowManyMore();
}

}  // namespace collision_monitor
