// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <memory>
#include <optional>

#include "ros_edge/markers/marker_thread.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/distance_list.h"
#include "ros_edge/outputs/warning_log.h"
#include "ros_edge/robots/robot_topics.h"

namespace collision_monitor {

/// All topics of the monitor. For the cycle's thread only. Messages without listeners are not
/// computed, except the state, which late listeners get.
class Publishers {
 public:
  /// @pre the log outlives them
  Publishers(ros::NodeHandle private_node, LogThread& log);

  /// Starts another set-up.
  void startWatch(const Watch& watch, std::shared_ptr<RobotTopics> robot_topics);

  /// Publishes and logs changes of verdict.
  void publishChanges(const Watch& watch);
  /// Reports that the new set-up no longer checks a pair that was not clear.
  void publishDropped(const Watch& former, LinkPairIndex pair);
  /// state, state_is_valid and speed_scale, also of each robot; contacts and distances.
  const State& publishCycle(const Watch& watch, const CycleFacts& facts);
  /// Has markers drawn, at most `marker_rate` times a wall second.
  /// @param is_new else only what could not be drawn before
  void drawMarkers(const Watch& watch, bool is_new);
  /// Publishes markers that have been drawn since the last call.
  void publishMarkers();

  /// Notes which topics have listeners, at most every 10 ms.
  void askWhoListens(ros::SteadyTime now);

  /// Whether somebody listens to the distances of all near pairs.
  bool tellsAll() const noexcept {
    return listeners_.to_contacts || listeners_.to_distances || listeners_.to_markers;
  }

 private:
  /// Which topics have listeners. Asking takes a lock and a search for the topic.
  struct Listeners {
    bool to_is_valid{false};
    bool to_speed_scale{false};
    bool to_contacts{false};
    bool to_distances{false};
    bool to_markers{false};
  };

  ros::Publisher state_publisher_;
  ros::Publisher is_valid_publisher_;
  ros::Publisher speed_scale_publisher_;
  ros::Publisher contacts_publisher_;
  ros::Publisher distances_publisher_;
  ros::Publisher warnings_publisher_;
  ros::Publisher markers_publisher_;
  ros::Publisher objects_publisher_;
  Listeners listeners_;
  ros::SteadyTime asked_;  ///< when listeners were last asked for
  std::shared_ptr<RobotTopics> robot_topics_;
  MarkerThread markers_;
  ros::SteadyTime last_markers_;
  bool owes_markers_{false};           ///< of a cycle that came too soon after the last picture
  std::optional<bool> is_valid_;       ///< as last sent
  std::optional<double> speed_scale_;  ///< as last sent
  WarningLog log_;
  State state_;
  Contacts contacts_;
  DistanceList distances_;
};

}  // namespace collision_monitor
