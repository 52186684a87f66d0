// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>

#include "ros_edge/markers/markers.h"
#include "ros_edge/markers/snapshot.h"
#include "ros_edge/prepared_message.h"
#include "ros_edge/threads/woken_thread.h"

namespace collision_monitor {

/// Draws markers on a thread of its own: with many objects that takes longer than a cycle. All
/// functions are for the cycle's thread, which never waits.
class MarkerThread {
 public:
  MarkerThread();

  /// Takes a snapshot of this cycle, to draw it.
  /// @return false if the last drawing was not fetched yet
  bool draw(const Watch& watch);
  /// A new MarkerArray, once for each drawing; null if there is none. Valid until draw().
  const PreparedMessage* fetch() noexcept;

 private:
  enum class Step : unsigned char { idle, drawing, drawn };

  void drawSnapshot();

  std::atomic<Step> step_{Step::idle};
  // While drawing, the next four are the drawing thread's, else the cycle's.
  Snapshot snapshot_;
  PreparedMessage drawn_;
  std::unique_ptr<Markers> markers_;
  std::weak_ptr<const MonitorSetup> setup_;  ///< of markers_
  WokenThread thread_;                       ///< last: it uses the others
};

}  // namespace collision_monitor
