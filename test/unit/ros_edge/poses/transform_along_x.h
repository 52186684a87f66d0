// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <string>
#include <vector>

namespace collision_monitor::test {

/// A translation along x, unrotated, with a stamp in seconds.
inline geometry_msgs::TransformStamped transformAlongX(const std::string& parent,
                                                       const std::string& child, double stamp,
                                                       double x) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.header.stamp = ros::Time(stamp);
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return transform;
}

}  // namespace collision_monitor::test
