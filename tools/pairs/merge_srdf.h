// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"
#include "report.h"

namespace collision_monitor::pairs_tool {

/// Of a URDF; empty where it has none or cannot be read.
std::string robotNameOf(const std::string& urdf_xml);

/// Adds an error if this is no SRDF of that robot, or none that can be merged into.
/// @param path what messages call it
/// @param robot_name empty: any
void checkMergeable(const std::string& path, const std::string& srdf_xml,
                    const std::string& robot_name, SetupReport& report);

/// An SRDF that was brought up to date.
struct SrdfMerge {
  std::string text;
  std::size_t added{0};
  std::size_t kept{0};
  std::size_t left_out{0};             ///< of PairLines::left_out, what the file does not have
  std::vector<std::string> taken_out;  ///< a sentence each
  std::vector<std::string> doubted;    ///< lines that were kept though their links may touch
};

/// Adds lines that are missing behind those that are there, or at the end, and takes out those that
/// are refuted: of links that were seen to touch and to be apart, with the reason "Never" or
/// "Always", which is what programs write that try states. All other lines stay: who wrote another
/// reason decided it, and of links that were not looked at nothing is known. So does every byte
/// of the file beside these lines. A pair that the file enables is not added.
/// @pre checkMergeable found nothing
/// @throws std::runtime_error if names do not fit the file's encoding
SrdfMerge mergeSrdf(const std::string& srdf_xml, const RobotModel& model,
                    const std::vector<PairFound>& pairs, const PairLines& lines);

}  // namespace collision_monitor::pairs_tool
