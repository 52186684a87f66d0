// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/setup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/model/kinematics.h"
#include "default_overlap.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

std::string inMetres(double value) { return std::to_string(value) + " m"; }

/// `unit` stands behind the numbers, as in " m".
void checkNumber(const std::string& name, double value, double least, const char* unit,
                 SetupReport& report) {
  if (!std::isfinite(value) || value < least) {
    report.errors.push_back(
        {name, std::to_string(value) + unit, "a finite number >= " + std::to_string(least) + unit});
  }
}

void checkLimit(const char* name, double value, double least, SetupReport& report) {
  checkNumber(std::string("limits, ") + name, value, least, " m", report);
}

void checkTime(const char* name, double value, double least, SetupReport& report) {
  checkNumber(std::string("limits, ") + name, value, least, " s", report);
}

void checkLookAhead(const LookAhead& ahead, SetupReport& report) {
  constexpr double kShortest = 1e-3;
  const StopRule& stop = ahead.stop;
  const double lowest = std::numeric_limits<double>::lowest();
  checkNumber("look_ahead, horizon", ahead.horizon, 0.0, " s", report);
  checkNumber("look_ahead, stop_distance", stop.stop_distance, lowest, " m", report);
  checkNumber("look_ahead, stop_time", stop.stop_time, kShortest, " s", report);
  checkNumber("look_ahead, release_time", stop.release_time, kShortest, " s", report);
  checkNumber("look_ahead, rest_speed", stop.rest_speed, 0.0, " m/s", report);
  checkNumber("look_ahead, creep_scale", stop.creep_scale, 0.0, "", report);
}

/// Pairs that a threshold of time or the speed scale may be about are within the horizon.
LookAhead lookAheadFor(const SetupOptions& options) {
  LookAhead ahead = options.ahead;
  ahead.horizon =
      std::max({ahead.horizon, options.limits.warning_time + options.limits.time_hysteresis,
                ahead.stop.stop_time});
  return ahead;
}

std::vector<SrdfPairs> readSrdfs(const std::vector<RobotDescription>& robots,
                                 const RobotModel& model, SetupReport& report) {
  std::vector<SrdfPairs> srdfs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!robots[i].srdf_xml.empty()) {
      srdfs.push_back(readSrdf(robots[i], idAt<RobotId>(i), model, report));
    }
  }
  return srdfs;
}

void warnIfNothingChecked(const CycleSetup& setup, SetupReport& report) {
  if (setup.checked.empty()) {
    report.warnings.push_back({"pairs", "no pair of links is checked",
                               "at least one; see the reasons of the ignored pairs"});
  }
}

}  // namespace

void checkLimits(const Limits& limits, SetupReport& report) {
  if (!std::isfinite(limits.contact_distance)) {
    report.errors.push_back(
        {"limits, contact_distance", inMetres(limits.contact_distance), "a finite number"});
  }
  checkLimit("warning_distance", limits.warning_distance, limits.contact_distance, report);
  checkLimit("report_distance", limits.report_distance, limits.warning_distance, report);
  checkLimit("hysteresis", limits.hysteresis, 0.0, report);
  checkTime("contact_time", limits.contact_time, 0.0, report);
  checkTime("warning_time", limits.warning_time, limits.contact_time, report);
  checkTime("time_hysteresis", limits.time_hysteresis, 0.0, report);
}

namespace {

void checkInput(const std::vector<RobotDescription>& robots, const SetupOptions& options,
                SetupReport& report) {
  checkLimits(options.limits, report);
  checkLimit("padding", options.padding, 0.0, report);
  checkLimit("target_overshoot", options.default_limits.target_overshoot, 0.0, report);
  if (options.default_limits.max_shapes == 0) {
    report.errors.push_back({"limits of fits, max_shapes", "0", "at least 1 shape a link"});
  }
  if (robots.empty()) {
    report.errors.push_back({"robots", "none", "at least one robot description"});
  }
  checkLimit("refine_distance", options.refine.limits.distance, 0.0, report);
  checkLookAhead(options.ahead, report);
}

}  // namespace

CycleSetup buildSetup(const std::vector<RobotDescription>& robots,
                      const ResourceLoader& load_resource, const SetupOptions& options) {
  CycleSetup setup;
  SetupReport report;
  checkInput(robots, options, report);
  setup.ahead = lookAheadFor(options);
  setup.limits = options.limits;
  setup.is_continuous = options.is_continuous;
  setup.refine = options.refine.limits;
  setup.refine.distance =
      std::max(setup.refine.distance, options.limits.warning_distance + options.limits.hysteresis);
  setup.model = readRobots(robots, load_resource, report);
  throwIfErrors(report);

  const std::vector<SrdfPairs> srdfs = readSrdfs(robots, setup.model, report);
  const FitSettings settings{options.default_limits, options.padding,
                             readShapeRules(options.shape_rules, setup.model, srdfs, report),
                             options.fit_cache};
  const std::vector<LinkIdPair> ignored =
      findNamedPairs(options.ignored_pairs, setup.model, report);
  throwIfErrors(report);
  const std::vector<LinkFit> fits = fitLinks(setup.model, settings, {}, report);
  makeBodies(fits, setup);
  throwIfErrors(report);
  makeElements(fits, {options.refine.geometry, settings.rules}, setup, report);

  setup.link_pairs = decideLinkPairs(setup.model, srdfs, ignored);
  ruleDefaultOverlaps(srdfs, options.ignore_default_overlap, setup, report);
  listPairs(setup);
  setup.velocity_names = velocityNames(setup.model);
  warnIfNothingChecked(setup, report);
  setup.report = std::move(report);
  return setup;
}

}  // namespace collision_monitor
