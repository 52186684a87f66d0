// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/world_places.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <thread>

#include "pipeline/data/cycle_data.h"
#include "ros_edge/poses/pose_reader.h"
#include "ros_edge/watch.h"

namespace collision_monitor {
namespace {

/// Tells which frames tf has, and waits for some.
class FrameSearch {
 public:
  FrameSearch(TransformStore& store, double patience) : store_(store), patience_(patience) {}

  bool has(const std::string& frame) {
    if (known_.count(frame) != 0) {
      return true;
    }
    if (missing_.count(frame) != 0) {
      return false;
    }
    store_.keepOnly({frame});
    look();
    if (known_.count(frame) == 0 && !deadline_) {
      deadline_ = SteadyClock::now() + std::chrono::duration_cast<SteadyClock::duration>(
                                           std::chrono::duration<double>(patience_));
    }
    while (known_.count(frame) == 0 && SteadyClock::now() < *deadline_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      look();
    }
    if (known_.count(frame) == 0) {
      missing_.insert(frame);
    }
    return known_.count(frame) != 0;
  }

 private:
  void look() {
    store_.copyRecords(records_);
    for (const FrameRecord& record : records_) {
      known_.insert(record.name);
      known_.insert(record.parent);
    }
  }

  TransformStore& store_;
  double patience_;
  std::optional<SteadyClock::time_point> deadline_;
  std::vector<FrameRecord> records_;
  std::set<std::string> known_;
  std::set<std::string> missing_;
};

/// The robots with two more frames, to be read once.
class PosePair {
 public:
  PosePair(const MonitorSetup& setup, const std::string& parent, const std::string& child)
      : model_(setup.robots->model),
        topics_(jointTopics(setup)),
        world_frame_(setup.world_frame),
        parent_(find(parent)),
        child_(find(child)) {
    topics_.resize(model_.robots.size());
  }

  std::optional<Pose> read(const MonitorSetup& setup, const Inputs& inputs) const {
    const ros::Time now = ros::Time::now();
    if (now.isZero() || lookAtClock(inputs, now).fault != ClockFault::none) {
      return std::nullopt;
    }
    JointReader joints(model_, inputs.joints, topics_);
    const bool reads_joints = setup.parameters.pose_source == PoseSource::joint_states;
    PoseReader reader(model_, inputs.transforms, {world_frame_, setup.parameters.max_age},
                      reads_joints ? &joints : nullptr);
    LinkPoses poses = makeLinkPoses(model_);
    reader.read(now, poses);
    return isJoined(poses, parent_, child_)
               ? std::optional<Pose>(inverse(poses.world_from_link[index(parent_)]) *
                                     poses.world_from_link[index(child_)])
               : std::nullopt;
  }

 private:
  /// The link of a name, or of a frame, which is added if there is none. It counts as one with
  /// shapes, so that it is placed.
  LinkId find(const std::string& name) {
    for (const bool is_name : {true, false}) {
      for (std::size_t i = 0; i < model_.links.size(); ++i) {
        if ((is_name ? model_.links[i].name : model_.links[i].frame) == name) {
          model_.links[i].has_given_shapes = true;
          return idAt<LinkId>(i);
        }
      }
    }
    Robot robot;
    robot.name = name;
    robot.root = idAt<LinkId>(model_.links.size());
    robot.first_link = model_.links.size();
    robot.link_count = 1;
    robot.first_joint = model_.joints.size();
    robot.is_world = true;
    Link link;
    link.name = link.frame = name;
    link.robot = idAt<RobotId>(model_.robots.size());
    link.has_given_shapes = true;
    model_.robots.push_back(robot);
    model_.links.push_back(link);
    return robot.root;
  }

  RobotModel model_;
  std::vector<std::string> topics_;
  std::string world_frame_;
  LinkId parent_;
  LinkId child_;
};

}  // namespace

KnownPlaces placesNow(const MonitorSetup& setup, const Inputs& inputs, double patience) {
  KnownPlaces places = placesOf(setup.robots->model, setup.world_frame);
  places.awaits_links = isAnyMissing(setup);
  const auto search = std::make_shared<FrameSearch>(inputs.transforms, patience);
  places.has_frame = [search](const std::string& frame) { return search->has(frame); };
  places.find_pose = [&setup, inputs](const std::string& parent, const std::string& child) {
    return PosePair(setup, parent, child).read(setup, inputs);
  };
  return places;
}

}  // namespace collision_monitor
