// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"
#include "report.h"

namespace collision_monitor::pairs_tool {

/// The robot's name in a URDF; empty if it has none or cannot be read.
std::string robotNameOf(const std::string& urdf_xml);

/// Adds an error if the text is no SRDF of that robot, or cannot be merged into.
/// @param path its name in messages
/// @param robot_name empty: any
/// @param option that names the file
void checkMergeable(const std::string& path, const std::string& srdf_xml,
                    const std::string& robot_name, const std::string& option, SetupReport& report);

/// An updated SRDF.
struct SrdfMerge {
  std::string text;
  std::size_t added{0};
  std::size_t kept{0};
  std::size_t left_out{0};             ///< those of PairLines::left_out that the file does not have
  std::vector<std::string> taken_out;  ///< one sentence each
  std::vector<std::string> doubted;    ///< lines that were kept although their links may touch
};

/// Adds missing lines after the existing ones, or at the end. Removes refuted lines: their links
/// were seen both touching and apart, and their reason is "Never" or "Always", which programs write
/// that sample states. Every other byte of the file stays: a line with another reason is a person's
/// decision, and nothing is known about links that were not examined. Does not add a pair that the
/// file enables.
/// @pre checkMergeable found nothing
/// @throws std::runtime_error if names do not fit the file's encoding
SrdfMerge mergeSrdf(const std::string& srdf_xml, const RobotModel& model,
                    const std::vector<PairFound>& pairs, const PairLines& lines);

}  // namespace collision_monitor::pairs_tool
