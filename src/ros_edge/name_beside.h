// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/names.h>
#include <ros/node_handle.h>

#include <string>

namespace collision_monitor {

/// The absolute name of something beside a node, not below it, before remapping. Only the private
/// handle knows a nodelet's remappings, and it resolves relative names below the node.
inline std::string nameBeside(const ros::NodeHandle& private_node, const std::string& name) {
  const std::string outer = ros::names::parentNamespace(private_node.getNamespace());
  return name.rfind('/', 0) == 0 ? name : ros::names::append(outer, name);
}

}  // namespace collision_monitor
