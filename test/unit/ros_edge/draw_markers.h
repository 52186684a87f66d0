// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ros_edge/markers/markers.h"

namespace collision_monitor::test {

/// The array of markers that shows a cycle.
inline visualization_msgs::MarkerArray draw(Markers& markers, const Watch& watch) {
  Snapshot snapshot;
  takeSnapshot(watch, snapshot);
  return markers.draw(snapshot);
}

/// The first array of a set-up.
inline visualization_msgs::MarkerArray drawFirst(const Watch& watch) {
  Markers markers(*watch.fixed);
  return draw(markers, watch);
}

}  // namespace collision_monitor::test
