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

/// How links get their shapes.
struct FitSettings {
  FitLimits limits;              ///< where the rules say nothing
  double padding{0.0};           ///< [m] where the rules say nothing
  std::vector<LinkRules> rules;  ///< by LinkId; empty for none
  /// Directory that keeps fits from one start to the next; made if missing; empty: none.
  std::filesystem::path cache_directory;
};

/// Where the shapes of a link come from.
enum class FitSource : unsigned char {
  fitted,    ///< computed now
  cached,    ///< read from the cache directory and proven again
  repeated,  ///< taken from another link of the same geometries and limits
  given,     ///< the user's shapes
};

/// As in messages: "fitted", "cached", "repeated" or "given".
const char* nameOf(FitSource source) noexcept;

/// The shapes of one link.
struct LinkFit {
  LinkId link{};                        ///< with geometry or given shapes
  FitSource source{FitSource::fitted};  ///< where its shapes come from
  std::vector<Fit> fits;  ///< one for each collision element, in its frame; none for given shapes
  /// Given shapes, in the link frame. Their overshoot is not measured: NaN.
  std::vector<Enclosure> given;
  bool is_proven{true};  ///< false: given shapes under the rule `unproven`
  double padding{0.0};   ///< [m] to be added to every shape
  double seconds{0.0};   ///< the time of fitting, or of loading and proving; else 0
};

/// Reports progress before each link that is fitted, in order, and once at the end with `done` ==
/// `total`. Calls never overlap.
using FitProgress =
    std::function<void(const std::string& link, std::size_t done, std::size_t total)>;

/// Given shapes may miss a geometry by this much, since files round their numbers. They are then
/// grown until they enclose it. Units: metres.
constexpr double kGivenTolerance = 1e-5;

/// Fits every link that has geometry or given shapes. The result is in order of link.
///
/// Uses all processors; the result does not depend on their number. Reads fits from the cache
/// directory where it has them. Links of the same geometries and limits share one fit. Proves that
/// given shapes cover the geometry of their link (fitting/covering.h).
///
/// Errors: geometry that no shape can enclose; given shapes that do not cover their link, with the
/// point that is farthest outside. Warnings: the same under the rule `unproven`; a cache directory
/// that cannot be written; files in it that could not be used.
/// @param progress may be empty
std::vector<LinkFit> fitLinks(const RobotModel& model, const FitSettings& settings,
                              const FitProgress& progress, SetupReport& report);

}  // namespace collision_monitor
