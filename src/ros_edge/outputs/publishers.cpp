// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/publishers.h"

#include <collision_monitor/SceneObjects.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include <utility>

#include "ros_edge/latched_value.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

constexpr std::uint32_t kQueueSize = 10;
/// Many pairs can change in one cycle, and each change is published only once.
constexpr std::uint32_t kWarningQueueSize = 1000;

/// [s] Longest delay until a new listener is noticed.
constexpr double kAskPeriod = 0.01;

}  // namespace

Publishers::Publishers(ros::NodeHandle private_node, LogThread& log)
    : state_publisher_(private_node.advertise<State>("state", kQueueSize, true)),
      is_valid_publisher_(
          private_node.advertise<std_msgs::Bool>("state_is_valid", kQueueSize, true)),
      speed_scale_publisher_(
          private_node.advertise<std_msgs::Float64>("speed_scale", kQueueSize, true)),
      contacts_publisher_(private_node.advertise<Contacts>("contacts", kQueueSize)),
      distances_publisher_(private_node.advertise<Distances>("distances", kQueueSize)),
      warnings_publisher_(private_node.advertise<PairWarning>("warnings", kWarningQueueSize)),
      markers_publisher_(
          private_node.advertise<visualization_msgs::MarkerArray>("markers", kQueueSize)),
      objects_publisher_(private_node.advertise<SceneObjects>("objects", 1, true)),
      log_(log) {}

void Publishers::startWatch(const Watch& watch, std::shared_ptr<RobotTopics> robot_topics) {
  if (watch.new_objects) {
    objects_publisher_.publish(*watch.new_objects);
  }
  robot_topics_ = std::move(robot_topics);
  robot_topics_->askWhoListens();
  distances_.forgetNames();
  log_.startWatch();
}

void Publishers::publishChanges(const Watch& watch) {
  for (const VerdictChange& change : watch.buffers.events.changes) {
    PairWarning warning;
    toMessage(watch, change, warning);
    warnings_publisher_.publish(warning);
    log_.logChange(warning, ros::SteadyTime::now());
  }
  log_.logUnknownLinks(watch);
  log_.logStep(watch);
}

void Publishers::publishDropped(const Watch& former, LinkPairIndex pair) {
  PairWarning warning;
  toDroppedMessage(former, pair, warning);
  warnings_publisher_.publish(warning);
  log_.logChange(warning, ros::SteadyTime::now());
}

void Publishers::askWhoListens(ros::SteadyTime now) {
  if ((now - asked_).toSec() < kAskPeriod) {
    return;
  }
  asked_ = now;
  listeners_.to_is_valid = is_valid_publisher_.getNumSubscribers() > 0;
  listeners_.to_speed_scale = speed_scale_publisher_.getNumSubscribers() > 0;
  listeners_.to_contacts = contacts_publisher_.getNumSubscribers() > 0;
  listeners_.to_distances = distances_publisher_.getNumSubscribers() > 0;
  listeners_.to_markers = markers_publisher_.getNumSubscribers() > 0;
  robot_topics_->askWhoListens();
}

/// Computes everything first, then sends it: each message wakes roscpp's network thread unless the
/// previous one has just done so.
const State& Publishers::publishCycle(const Watch& watch, const CycleFacts& facts) {
  toMessage(watch, facts, state_);
  if (listeners_.to_contacts) {
    toMessage(watch, contacts_);
  }
  const Distances* distances = listeners_.to_distances ? &distances_.fill(watch) : nullptr;
  state_publisher_.publish(state_);
  publishLatched<std_msgs::Bool>(vouchesFor(facts.is_enabled, state_.level), listeners_.to_is_valid,
                                 is_valid_publisher_, is_valid_);
  publishLatched<std_msgs::Float64>(state_.speed_scale, listeners_.to_speed_scale,
                                    speed_scale_publisher_, speed_scale_);
  robot_topics_->publish(state_.robots, facts.is_enabled);
  if (listeners_.to_contacts) {
    contacts_publisher_.publish(contacts_);
  }
  if (distances != nullptr) {
    distances_publisher_.publish(*distances);
  }
  return state_;
}

void Publishers::drawMarkers(const Watch& watch, bool is_new) {
  owes_markers_ = owes_markers_ || is_new;
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double period = 1.0 / watch.fixed->parameters.marker_rate;
  if (!owes_markers_ || !listeners_.to_markers || (now - last_markers_).toSec() < period) {
    return;
  }
  if (markers_.draw(watch)) {
    last_markers_ = now;
    owes_markers_ = false;
  }
}

void Publishers::publishMarkers() {
  if (const PreparedMessage* drawn = markers_.fetch()) {
    markers_publisher_.publish(*drawn);
  }
}

}  // namespace collision_monitor
