// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <boost/interprocess/sync/interprocess_semaphore.hpp>
#include <memory>
#include <thread>

#include "ros_edge/markers/markers.h"
#include "ros_edge/markers/snapshot.h"
#include "ros_edge/prepared_message.h"

namespace collision_monitor {

/// Draws markers on a thread of its own: with many objects that takes longer than a cycle. The
/// other functions are for the cycle's thread, which never waits.
class MarkerThread {
 public:
  MarkerThread();
  /// Waits for the current drawing.
  ~MarkerThread();
  MarkerThread(const MarkerThread&) = delete;
  MarkerThread& operator=(const MarkerThread&) = delete;

  /// Takes a snapshot of this cycle, to draw it.
  /// @return false if the last drawing was not fetched yet
  bool draw(const Watch& watch);
  /// A new MarkerArray, once for each drawing; null if there is none. Valid until draw().
  const PreparedMessage* fetch() noexcept;

 private:
  enum class Step : unsigned char { idle, drawing, drawn };

  void run();
  void drawSnapshot();

  std::atomic<Step> step_{Step::idle};
  std::atomic<bool> is_ending_{false};
  boost::interprocess::interprocess_semaphore woken_{0};  ///< posting it takes no lock
  // While drawing, the next four are the drawing thread's, else the cycle's.
  Snapshot snapshot_;
  PreparedMessage drawn_;
  std::unique_ptr<Markers> markers_;
  std::weak_ptr<const MonitorSetup> setup_;  ///< of markers_
  std::thread thread_;
};

}  // namespace collision_monitor
