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

CycleSetup buildFrom(SetupInput input, const SetupOptions& options, SetupReport report) {
  CycleSetup setup;
  setup.ahead = lookAheadFor(options);
  setup.least_horizon = setup.ahead.horizon;
  setup.memory_limit = options.memory_limit;
  setup.limits = options.limits;
  setup.is_continuous = options.is_continuous;
  setup.refine = options.refine.limits;
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

CycleSetup buildSetup(const std::vector<RobotDescription>& robots,
                      const ResourceLoader& load_resource, const SetupOptions& options) {
  SetupReport report;
  report.awaits_names = options.awaits_names;
  if (robots.empty()) {
    report.errors.push_back({"robots", "none", "at least one robot description"});
  }
  checkOptions(options, report);
  SetupInput input = readInput(robots, load_resource, options, report);
  throwIfErrors(report);
  return buildFrom(std::move(input), options, std::move(report));
}

}  // namespace collision_monitor
