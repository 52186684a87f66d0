// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/setup.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/model/kinematics.h"
#include "default_overlap.h"
#include "memory_need.h"
#include "model/number_text.h"
#include "setup_input.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

/// Checks the numbers of one struct of options.
struct NumberCheck {
  std::string where;  ///< stands before their names
  SetupReport& report;

  /// @param unit stands behind the numbers, as in " m".
  void atLeast(double least, const char* name, double value, const char* unit) const {
    if (!std::isfinite(value) || value < least) {
      report.errors.push_back(
          {where + name, shortText(value) + unit, "a finite number >= " + shortText(least) + unit});
    }
  }

  void isWithin(double least, double most, const char* name, double value, const char* unit) const {
    if (!(value >= least && value <= most)) {
      report.errors.push_back(
          {where + name, shortText(value) + unit,
           "from " + shortText(least) + unit + " to " + shortText(most) + unit});
    }
  }

  void isFinite(const char* name, double value, const char* unit) const {
    if (!std::isfinite(value)) {
      report.errors.push_back({where + name, shortText(value) + unit, "a finite number"});
    }
  }
};

void checkLookAhead(const LookAhead& ahead, const std::string& where, SetupReport& report) {
  constexpr double kShortest = 1e-3;
  const StopRule& stop = ahead.stop;
  const NumberCheck check{where, report};
  check.atLeast(0.0, "horizon", ahead.horizon, " s");
  check.isFinite("stop_distance", stop.stop_distance, " m");
  check.atLeast(kShortest, "stop_time", stop.stop_time, " s");
  check.atLeast(kShortest, "release_time", stop.release_time, " s");
  check.atLeast(0.0, "rest_speed", stop.rest_speed, " m/s");
  check.atLeast(0.0, "creep_scale", stop.creep_scale, "");
}

/// Raises the horizon to what the speed scale needs.
LookAhead lookAheadFor(const SetupOptions& options) {
  LookAhead ahead = options.ahead;
  ahead.horizon = std::max(ahead.horizon, ahead.stop.stop_time);
  return ahead;
}

void warnIfNothingChecked(const CycleSetup& setup, SetupReport& report) {
  if (setup.checked.empty()) {
    report.warnings.push_back(
        {kPairsWarning, "no pair of links is checked", "",
         "the state stays UNKNOWN; the line at start tells why pairs are left "
         "out"});
  }
}

}  // namespace

void checkLimits(const Limits& limits, const std::string& where, SetupReport& report) {
  const NumberCheck check{where, report};
  check.isFinite("contact_distance", limits.contact_distance, " m");
  check.atLeast(limits.contact_distance, "warning_distance", limits.warning_distance, " m");
  check.atLeast(limits.warning_distance, "report_distance", limits.report_distance, " m");
  check.atLeast(0.0, "hysteresis", limits.hysteresis, " m");
  check.atLeast(0.0, "contact_time", limits.contact_time, " s");
  check.atLeast(limits.contact_time, "warning_time", limits.warning_time, " s");
  check.atLeast(0.0, "time_hysteresis", limits.time_hysteresis, " s");
}

namespace {

void checkInput(const std::vector<RobotDescription>& robots, const SetupOptions& options,
                SetupReport& report) {
  checkLimits(options.limits, options.where + "limits/", report);
  const NumberCheck check{options.where, report};
  check.atLeast(0.0, "padding", options.padding, " m");
  check.atLeast(0.0, "target_overshoot", options.default_limits.target_overshoot, " m");
  if (options.default_limits.max_shapes == 0) {
    report.errors.push_back(
        {options.where + "max_shapes_per_link", "0", "at least 1 shape a link"});
  }
  if (robots.empty()) {
    report.errors.push_back({"robots", "none", "at least one robot description"});
  }
  check.atLeast(0.0, "refine_distance", options.refine.limits.distance, " m");
  check.isWithin(0.0, std::max(0.0, options.limits.warning_distance), "distance_tolerance",
                 options.refine.limits.tolerance, " m");
  checkLookAhead(options.ahead, options.where + "look_ahead/", report);
}

/// Checks the size of everything that grows with the square of links, before it is made.
/// @throws SetupError
void decidePairs(const std::vector<LinkIdPair>& ignored, const SetupOptions& options,
                 CycleSetup& setup, SetupReport& report) {
  checkMemory(countPairs(setup), setup.memory_limit, report);
  throwIfErrors(report);
  setup.link_pairs = decideLinkPairs(setup.model, setup.srdfs, ignored);
  decideByRules(options.idle_rules, setup, report);
  checkMemory(countPairs(setup), setup.memory_limit, report);
  throwIfErrors(report);
}

}  // namespace

CycleSetup buildSetup(const std::vector<RobotDescription>& robots,
                      const ResourceLoader& load_resource, const SetupOptions& options) {
  CycleSetup setup;
  SetupReport report;
  report.awaits_names = options.awaits_names;
  checkInput(robots, options, report);
  setup.ahead = lookAheadFor(options);
  setup.least_horizon = setup.ahead.horizon;
  setup.memory_limit = options.memory_limit;
  setup.limits = options.limits;
  setup.is_continuous = options.is_continuous;
  setup.refine = options.refine.limits;
  SetupInput input = readInput(robots, load_resource, options, report);
  throwIfErrors(report);
  setup.model = std::move(input.model);
  setup.srdfs = std::move(input.srdfs);
  setup.pair_rules = std::move(input.pair_rules);

  const FitSettings settings{options.default_limits, options.padding, input.link_rules,
                             options.fit_cache};
  const std::vector<LinkFit> fits = fitLinks(setup.model, settings, options.fit_progress, report);
  makeBodies(fits, setup);
  throwIfErrors(report);
  makeElements(fits, {options.refine.geometry, settings.rules}, setup, report);

  decidePairs(input.ignored, options, setup, report);
  ruleDefaultOverlaps(setup.srdfs, fits, options.ignore_default_overlap, setup, report);
  listPairs(setup);
  setup.velocity_names = velocityNames(setup.model);
  warnIfNothingChecked(setup, report);
  setup.report = std::move(report);
  return setup;
}

}  // namespace collision_monitor
