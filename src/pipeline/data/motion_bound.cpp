// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/motion_bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// The joint that moves a link, if it is a joint of the path.
std::optional<ChainJoint> movedJoint(const RobotModel& model, const JointPath& path, LinkId link) {
  const auto& parent_joint = model.link(link).parent_joint;
  if (!parent_joint) {
    return std::nullopt;
  }
  const Joint& joint = model.joint(*parent_joint);
  const JointId source = joint.mimic ? joint.mimic->source : *parent_joint;
  const auto place = std::find(path.joints.begin(), path.joints.end(), source);
  if (place == path.joints.end() || joint.type == JointType::fixed) {
    return std::nullopt;
  }
  return ChainJoint{link, joint.axis, joint.type == JointType::prismatic,
                    static_cast<std::size_t>(place - path.joints.begin()),
                    joint.mimic ? joint.mimic->multiplier : 1.0};
}

/// [m] Adds what a joint moves points of a link's ball to what joints nearer to it move them.
double movedBy(const ChainJoint& joint, LinkId link, const std::vector<double>& travels,
               double moved, JointLevers& levers) noexcept {
  const double travel = std::abs(joint.factor) * travels[joint.path_joint];
  if (travel == 0.0 || joint.is_prismatic) {
    return moved + travel;
  }
  return moved + travel * (levers.of(joint, link) + levers.radius(link) + moved);
}

}  // namespace

std::vector<LinkId> linksToRoot(const RobotModel& model, LinkId link) {
  std::vector<LinkId> chain{link};
  while (const auto& joint = model.link(chain.back()).parent_joint) {
    chain.push_back(model.joint(*joint).parent);
  }
  return chain;
}

LinkChain chainBetween(const RobotModel& model, const JointPath& path, LinkId a, LinkId b) {
  std::vector<LinkId> up = linksToRoot(model, a);
  std::vector<LinkId> down = linksToRoot(model, b);
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  LinkChain chain{a, b, {}};
  for (const LinkId link : up) {
    if (auto joint = movedJoint(model, path, link)) {
      joint->factor = -joint->factor;
      chain.joints.push_back(*joint);
    }
  }
  for (auto link = down.rbegin(); link != down.rend(); ++link) {
    if (const auto joint = movedJoint(model, path, *link)) {
      chain.joints.push_back(*joint);
    }
  }
  return chain;
}

std::vector<Ball> linkBalls(const CycleSetup& setup) {
  std::vector<Ball> balls(setup.model.links.size());
  std::vector<Aabb> boxes(setup.model.links.size(), {Eigen::Vector3d::Constant(kInfinity),
                                                     Eigen::Vector3d::Constant(-kInfinity)});
  for (const Body& body : setup.bodies) {
    const Aabb box = aabbOf(body.shape, body.link_from_body, 0.0);
    Aabb& all = boxes[index(body.link)];
    all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
  }
  for (const Body& body : setup.bodies) {
    Ball& ball = balls[index(body.link)];
    const Aabb& box = boxes[index(body.link)];
    ball.center = 0.5 * (box.min + box.max);
    const double reach =
        (body.link_from_body.translation - ball.center).norm() + body.bounding_radius;
    ball.radius = std::max(ball.radius, reach);
  }
  return balls;
}

JointLevers::JointLevers(std::vector<Ball> balls, const RobotModel& model, const JointPath& path)
    : balls_(std::move(balls)), axis_of_(model.links.size(), kNone) {
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (movedJoint(model, path, idAt<LinkId>(link))) {
      axis_of_[link] = static_cast<std::uint32_t>(axes_++);
    }
  }
  levers_.resize(balls_.size() * axes_);
}

void JointLevers::moveTo(const std::vector<Pose>& world_from_link) noexcept {
  world_from_link_ = &world_from_link;
  ++time_;
}

double JointLevers::measure(const ChainJoint& joint, LinkId link) const noexcept {
  const Pose& frame = (*world_from_link_)[index(joint.child)];
  const Eigen::Vector3d center = (*world_from_link_)[index(link)] * balls_[index(link)].center;
  return (frame.rotation * joint.axis).cross(center - frame.translation).norm();
}

double boundMotion(const LinkChain& chain, const std::vector<double>& travels,
                   JointLevers& levers) noexcept {
  // The chain is split after one of its first joints, at most this many.
  constexpr std::size_t kMostSplits = 32;
  std::array<double, kMostSplits + 1> moved_b;
  double of_b = 0.0;
  for (std::size_t split = chain.joints.size(); split > 0; --split) {
    moved_b[std::min(split, kMostSplits)] = of_b;
    of_b = movedBy(chain.joints[split - 1], chain.b, travels, of_b, levers);
  }
  double least = of_b;
  double of_a = 0.0;
  for (std::size_t split = 1; split <= std::min(chain.joints.size(), kMostSplits); ++split) {
    of_a = movedBy(chain.joints[split - 1], chain.a, travels, of_a, levers);
    least = std::min(least, of_a + moved_b[split]);
  }
  return least;
}

LinkChain reversed(const LinkChain& chain) {
  LinkChain other{chain.b, chain.a, {chain.joints.rbegin(), chain.joints.rend()}};
  for (ChainJoint& joint : other.joints) {
    joint.factor = -joint.factor;
  }
  return other;
}

RelativeMotion relativeMotion(const LinkChain& chain, const std::vector<Ball>& balls,
                              const std::vector<Pose>& world_from_link,
                              const std::vector<JointStep>& steps) noexcept {
  double turned = 0.0;  // by the joints nearer to A than the current one
  for (const ChainJoint& joint : chain.joints) {
    const JointStep& step = steps[joint.path_joint];
    turned += joint.is_prismatic ? 0.0 : std::abs(joint.factor) * (std::abs(step.half) + step.bend);
  }
  const Ball& b = balls[index(chain.b)];
  RelativeMotion motion;
  motion.center = world_from_link[index(chain.b)] * b.center;
  double moved = 0.0;  // by the joints nearer to B
  for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
    const JointStep& step = steps[joint->path_joint];
    const double half = joint->factor * step.half;
    const double bend = std::abs(joint->factor) * step.bend;
    const double most = std::abs(half) + bend;
    const Pose& frame = world_from_link[index(joint->child)];
    const Eigen::Vector3d axis = frame.rotation * joint->axis;
    double lever = 1.0;
    double turns = 0.0;
    if (joint->is_prismatic) {
      motion.velocity += half * axis;
    } else {
      const Eigen::Vector3d across = axis.cross(motion.center - frame.translation);
      lever = across.norm() + b.radius + moved;
      turns = most;
      motion.velocity += half * across;
      motion.turn += half * axis;
    }
    turned -= turns;
    motion.deviation += lever * (bend + most * (0.5 * turns + std::max(0.0, turned)));
    moved += most * lever;
  }
  return motion;
}

}  // namespace collision_monitor
