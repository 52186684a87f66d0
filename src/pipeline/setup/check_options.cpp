// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "model/number_text.h"
#include "pipeline/setup/setup_input.h"

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

void checkOptions(const SetupOptions& options, SetupReport& report) {
  checkLimits(options.limits, options.where + "limits/", report);
  const NumberCheck check{options.where, report};
  check.atLeast(0.0, "padding", options.padding, " m");
  check.atLeast(0.0, "target_overshoot", options.default_limits.target_overshoot, " m");
  if (options.default_limits.max_shapes == 0) {
    report.errors.push_back(
        {options.where + "max_shapes_per_link", "0", "at least 1 shape a link"});
  }
  check.atLeast(0.0, "refine_distance", options.refine.limits.distance, " m");
  check.isWithin(0.0, std::max(0.0, options.limits.warning_distance), "distance_tolerance",
                 options.refine.limits.tolerance, " m");
  checkLookAhead(options.ahead, options.where + "look_ahead/", report);
}

}  // namespace collision_monitor
