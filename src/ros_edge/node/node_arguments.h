// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace collision_monitor {

// Exit codes, the same for all programs.
constexpr int kDone = 0;
constexpr int kFault = 1;
constexpr int kUsageFault = 2;

/// Handles a node's command line beside ROS's NAME:=VALUE, before the node exists. --help prints
/// the usage; anything else is an error.
/// @return an exit code; nothing: run the node
std::optional<int> answerArguments(int argc, char** argv, const std::string& usage);

/// As ros::init, but prints one line if the name of the node or of a remapping is invalid.
/// @return an exit code; nothing: run the node
std::optional<int> initNode(int& argc, char** argv, const std::string& name);

}  // namespace collision_monitor
