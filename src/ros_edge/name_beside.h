// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/names.h>
#include <ros/node_handle.h>

#include <string>

namespace collision_monitor {

/// The absolute name of what stands beside a node and not below it, not remapped yet. Only the
/// node's private handle knows what is remapped for a nodelet, and it takes relative names as below
/// the node.
inline std::string nameBeside(const ros::NodeHandle& private_node, const std::string& name) {
  const std::string outer = ros::names::parentNamespace(private_node.getNamespace());
  return name.rfind('/', 0) == 0 ? name : ros::names::append(outer, name);
}

}  // namespace collision_monitor
