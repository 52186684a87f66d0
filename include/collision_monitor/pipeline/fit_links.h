// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/shape_rules.h"

namespace collision_monitor {

/// How the links of a model get their shapes.
struct FitSettings {
  FitLimits limits;              ///< where the rules are silent
  double padding{0.0};           ///< [m] where the rules are silent
  std::vector<LinkRules> rules;  ///< by LinkId; empty for none
  /// Where fits are kept from one start to the next, made when it is not there; empty: nowhere.
  std::filesystem::path cache_directory;
};

enum class FitSource : unsigned char {
  fitted,    ///< now
  cached,    ///< read from the directory and proven anew
  repeated,  ///< that of another link with the same geometries and limits
  given,     ///< the user's shapes
};

const char* nameOf(FitSource source) noexcept;

/// The shapes of one link.
struct LinkFit {
  LinkId link{};
  FitSource source{FitSource::fitted};
  std::vector<Fit> fits;  ///< one a collision element, in its frame; none where shapes are given
  /// Given shapes, in the link frame in place of the geometry's; overshoot is not measured: NaN.
  std::vector<Enclosure> given;
  bool is_proven{true};  ///< false: given shapes for which the user answers
  double padding{0.0};   ///< [m] to be added to every shape
  double seconds{0.0};   ///< fitting took, or loading and proving; 0 for the others
};

/// Called before each link that is fitted, in their order, and once at the end with `done` ==
/// `total`. Never on two threads at once.
using FitProgress =
    std::function<void(const std::string& link, std::size_t done, std::size_t total)>;

/// Given shapes may be short by this much, as the digits of a file make them: they are grown by
/// what is missing. Units: metres.
constexpr double kGivenTolerance = 1e-5;

/// Shapes for every link that has geometry or given shapes, in order of link.
///
/// Works on all processors; what comes out does not depend on how many there are.
/// Fits come from the cache directory where it has them. Links that have the same geometries and
/// limits share one fit. Given shapes are proven to cover the link's geometry (fitting/covering.h).
///
/// Errors: geometry that no shape can enclose; given shapes that do not cover their link, with
/// the point farthest outside. Warnings: the same where the rule says `unproven`; a cache
/// directory that cannot be written; files in it that were of no use.
/// @param progress may be empty
std::vector<LinkFit> fitLinks(const RobotModel& model, const FitSettings& settings,
                              const FitProgress& progress, SetupReport& report);

}  // namespace collision_monitor
