// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/publishers.h"

#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include "ros_edge/sentences.h"

namespace collision_monitor {
namespace {

constexpr std::uint32_t kQueueSize = 10;
/// Many pairs can change in one cycle, and each change is said once only.
constexpr std::uint32_t kWarningQueueSize = 1000;

/// In the sense of cob_collision_monitor: false stops whoever listens. A monitor that does not know
/// or is switched off vouches for nothing.
bool isValid(const State& state) {
  return state.enabled != 0 && (state.level == State::OK || state.level == State::WARNING);
}

}  // namespace

Publishers::Publishers(ros::NodeHandle private_node)
    : state_publisher_(private_node.advertise<State>("state", kQueueSize, true)),
      is_valid_publisher_(
          private_node.advertise<std_msgs::Bool>("state_is_valid", kQueueSize, true)),
      speed_scale_publisher_(
          private_node.advertise<std_msgs::Float64>("speed_scale", kQueueSize, true)),
      contacts_publisher_(private_node.advertise<Contacts>("contacts", kQueueSize)),
      distances_publisher_(private_node.advertise<Distances>("distances", kQueueSize)),
      warnings_publisher_(private_node.advertise<Warning>("warnings", kWarningQueueSize)),
      markers_publisher_(
          private_node.advertise<visualization_msgs::MarkerArray>("markers", kQueueSize)) {}

void Publishers::startWatch(const Watch& watch) {
  markers_ = std::make_unique<Markers>(watch);
  log_.reset();
}

void Publishers::publishChanges(const Watch& watch) {
  for (const VerdictChange& change : watch.buffers.events.changes) {
    Warning warning;
    toMessage(watch, change, warning);
    warnings_publisher_.publish(warning);
    log_.logChange(watch, change, warning.sentence);
  }
  log_.logUnknownLinks(watch);
}

const State& Publishers::publishState(const Watch& watch, const CycleFacts& facts) {
  toMessage(watch, facts, state_);
  state_publisher_.publish(state_);
  std_msgs::Bool is_valid;
  is_valid.data = isValid(state_) ? 1 : 0;
  is_valid_publisher_.publish(is_valid);
  std_msgs::Float64 speed_scale;
  speed_scale.data = state_.speed_scale;
  speed_scale_publisher_.publish(speed_scale);
  return state_;
}

void Publishers::publishResults(const Watch& watch) {
  if (contacts_publisher_.getNumSubscribers() > 0) {
    toMessage(watch, contacts_);
    contacts_publisher_.publish(contacts_);
  }
  if (distances_publisher_.getNumSubscribers() > 0) {
    toMessage(watch, distances_);
    distances_publisher_.publish(distances_);
  }
}

void Publishers::publishMarkers(const Watch& watch) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double period = 1.0 / watch.fixed->parameters.marker_rate;
  if (markers_publisher_.getNumSubscribers() == 0 || (now - last_markers_).toSec() < period) {
    return;
  }
  last_markers_ = now;
  markers_publisher_.publish(markers_->draw(watch));
}

}  // namespace collision_monitor
