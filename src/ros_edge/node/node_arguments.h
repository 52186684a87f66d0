// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace collision_monitor {

// Exit codes, as of all programs.
constexpr int kDone = 0;
constexpr int kFault = 1;
constexpr int kUsageFault = 2;

/// Answers what stands on a node's command line beside ROS's own NAME:=VALUE, before there is a
/// node: --help prints the usage, anything else is an error.
/// @return an exit code; nothing: the node is to run
std::optional<int> answerArguments(int argc, char** argv, const std::string& usage);

/// As ros::init, with one line for a name of the node or of a remapping that is none.
/// @return an exit code; nothing: the node is to run
std::optional<int> initNode(int& argc, char** argv, const std::string& name);

}  // namespace collision_monitor
