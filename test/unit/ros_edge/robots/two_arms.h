// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "support/robots/urdf_text.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {

/// Two robots, left and right, of two balls of 0.1 m each: base and, on a slide, hand. Bases are at
/// y = 0 and 5 m, hands 1 m ahead of them in x. Checked are the four pairs across the robots.
class TwoArms : public testing::Test {
 protected:
  TwoArms() {
    const std::string ball = "<sphere radius='0.1'/>";
    const std::string xml = robotXml(
        linkXml("base", ball) + linkXml("hand", ball) +
        jointXml("slide", "prismatic", "base", "hand",
                 "<axis xyz='1 0 0'/><limit lower='-9' upper='9' velocity='1' effort='1'/>"));
    for (const char* prefix : {"left", "right"}) {
      descriptions_.push_back(describeText(xml));
      descriptions_.back().tf_prefix = prefix;
      setup_->listed.push_back({prefix, idAt<RobotId>(descriptions_.size() - 1), "", false});
    }
    setup_->setup = buildSetup(descriptions_, textLoader({}), SetupOptions());
    setup_->world_frame = "cell";
    poses_ = makeLinkPoses(setup_->setup.model);
    std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
    std::fill(poses_.part_status.begin(), poses_.part_status.end(), LinkStatus::known);
    std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
    poses_.stamp_ns = 12'500'000'000;
    place("left/hand", {1.0, 0.0, 0.0});
    place("right/base", {0.0, 5.0, 0.0});
    place("right/hand", {1.0, 5.0, 0.0});
  }

  std::size_t link(const std::string& name) const {
    return index(linkNamed(setup_->setup.model, name));
  }
  void place(const std::string& name, const Eigen::Vector3d& position) {
    poses_.world_from_link[link(name)].translation = position;
  }
  /// Its joint is silent.
  void lose(const std::string& name) { floatFrom(link(name), LinkStatus::stale, poses_); }

  /// A watch that has run one cycle.
  std::unique_ptr<Watch> watchNow(Watch* former = nullptr) {
    static const JointStore no_joint_states;
    auto watch = std::make_unique<Watch>(setup_, store_, no_joint_states);
    LinkPoses unused = makeLinkPoses(setup_->setup.model);
    watch->reader.read(ros::Time(13.0), unused);  // it explains what it has read
    if (former != nullptr) {
      watch->takeOver(*former);
    }
    watch->poses = poses_;
    watch->cycle();
    return watch;
  }
  static State stateOf(const Watch& watch, const CycleFacts& facts = factsNow()) {
    State state;
    toMessage(watch, facts, state);
    return state;
  }
  State stateNow(const CycleFacts& facts = factsNow()) { return stateOf(*watchNow(), facts); }
  static CycleFacts factsNow() {
    CycleFacts facts;
    facts.now = ros::Time(13.0);
    return facts;
  }

  TransformStore store_;
  std::vector<RobotDescription> descriptions_;
  std::shared_ptr<MonitorSetup> setup_ = std::make_shared<MonitorSetup>();
  LinkPoses poses_;
};

}  // namespace collision_monitor::test
