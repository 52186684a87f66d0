// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <memory>
#include <optional>

#include "ros_edge/markers/markers.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/distance_list.h"
#include "ros_edge/outputs/warning_log.h"

namespace collision_monitor {

/// All topics of the monitor. Used by the thread of the cycle alone. Messages that nobody
/// listens to are not computed; only the state is, for those who come late.
class Publishers {
 public:
  explicit Publishers(ros::NodeHandle private_node);

  /// Another set-up is watched from now on.
  void startWatch(const Watch& watch);

  /// Changes of verdict, on the topic and in the log.
  void publishChanges(const Watch& watch);
  /// That another set-up checks no more what was not clear.
  void publishDropped(const Watch& former, LinkPairIndex pair);
  /// state, state_is_valid and speed_scale; contacts and distances.
  const State& publishCycle(const Watch& watch, const CycleFacts& facts);
  /// markers, at most `marker_rate` times a wall second.
  void publishMarkers(const Watch& watch);

 private:
  /// Who listens, and to which topics. To ask takes a lock and a search for the topic.
  struct Listeners {
    bool to_is_valid{false};
    bool to_speed_scale{false};
    bool to_contacts{false};
    bool to_distances{false};
    bool to_markers{false};
  };

  void askWhoListens(ros::SteadyTime now);

  ros::Publisher state_publisher_;
  ros::Publisher is_valid_publisher_;
  ros::Publisher speed_scale_publisher_;
  ros::Publisher contacts_publisher_;
  ros::Publisher distances_publisher_;
  ros::Publisher warnings_publisher_;
  ros::Publisher markers_publisher_;
  Listeners listeners_;
  ros::SteadyTime asked_;  ///< for listeners
  std::unique_ptr<Markers> markers_;
  ros::SteadyTime last_markers_;
  std::optional<bool> is_valid_;       ///< as last sent
  std::optional<double> speed_scale_;  ///< as last sent
  WarningLog log_;
  State state_;
  Contacts contacts_;
  DistanceList distances_;
};

}  // namespace collision_monitor
