// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher.h>

#include <atomic>
#include <boost/interprocess/sync/interprocess_semaphore.hpp>
#include <memory>
#include <thread>

#include "ros_edge/markers/markers.h"
#include "ros_edge/markers/snapshot.h"

namespace collision_monitor {

/// Draws and publishes markers on a thread of its own: with many objects that takes longer than a
/// cycle. The cycle's thread hands snapshots over, and never waits.
class MarkerThread {
 public:
  explicit MarkerThread(ros::Publisher publisher);
  /// Waits for the current drawing.
  ~MarkerThread();
  MarkerThread(const MarkerThread&) = delete;
  MarkerThread& operator=(const MarkerThread&) = delete;

  /// Takes and draws a snapshot of this cycle. For the cycle's thread.
  /// @return false if the last one is not drawn yet
  bool draw(const Watch& watch);

 private:
  void run();
  void drawSnapshot();

  ros::Publisher publisher_;
  Snapshot snapshot_;                  ///< of the cycle's thread until is_taken_, then of the other
  std::atomic<bool> is_taken_{false};  ///< and not drawn yet
  std::atomic<bool> is_ending_{false};
  boost::interprocess::interprocess_semaphore woken_{0};  ///< posting it takes no lock
  std::unique_ptr<Markers> markers_;
  std::weak_ptr<const MonitorSetup> drawn_;  ///< what markers_ are for
  std::thread thread_;
};

}  // namespace collision_monitor
