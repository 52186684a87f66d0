// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/budget_report.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "ros_edge/numbered_values.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/pace.h"

namespace collision_monitor {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace {

/// A link pair that takes much of the budget.
struct Eater {
  LinkId a{};
  LinkId b{};
  double share{0.0};
};

std::vector<Eater> eatersOf(const CycleSetup& setup, const BudgetUse& use) {
  std::vector<Eater> eaters;
  for (const PairWork& pair : use.most) {
    if (pair.link_pair != kNone) {
      const CheckedLinkPair& links = setup.checked.at(pair.link_pair);
      eaters.push_back(
          {links.a, links.b, static_cast<double>(pair.work) / static_cast<double>(use.short_work)});
    }
  }
  return eaters;
}

const std::string& nameOf(LinkId link, const CycleSetup& setup) {
  return setup.model.link(link).name;
}

std::string pairText(const Eater& pair, const CycleSetup& setup) {
  return nameInText(setup.model, pair.a) + " and " + nameInText(setup.model, pair.b);
}

/// A number as written in a parameter file: "0.0001", "100".
std::string parameterText(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string percentText(double share) { return fixedText(100.0 * share, 0) + " %"; }

/// Triangles of meshes that are searched, so not of meshes that are convex or refined to hulls.
std::size_t searchedTriangles(LinkId link, const CycleSetup& setup) {
  std::size_t count = 0;
  for (const Element& element : setup.elements) {
    const bool is_searched = element.link == link && element.mesh && !element.convex;
    count += is_searched ? element.mesh->triangles().size() : 0;
  }
  return count;
}

/// The link with more triangles; none if neither has a mesh that is searched.
std::optional<LinkId> densestOf(const Eater& pair, const CycleSetup& setup) {
  const std::size_t of_a = searchedTriangles(pair.a, setup);
  const std::size_t of_b = searchedTriangles(pair.b, setup);
  if (of_a + of_b == 0) {
    return std::nullopt;
  }
  return of_a < of_b ? pair.b : pair.a;
}

/// [s] Mean time of the cycles for which the budget was too small.
double timeOfShort(const BudgetUse& use) {
  return use.short_time / static_cast<double>(std::max<std::uint64_t>(use.short_cycles, 1));
}

/// A larger budget makes cycles longer. Without spare time the rate must become lower as well.
std::string budgetAdvice(const Parameters& parameters, const RefineLimits& limits, double time) {
  constexpr double kRoom = 0.5;
  const double period = periodOf(parameters);
  const std::string now = std::to_string(limits.budget) + " now";
  const std::string took = "cycles that ran out of it took " + fixedText(1e3 * time, 1) +
                           " ms on average; a period is " + fixedText(1e3 * period, 1) + " ms";
  return time < kRoom * period ? "raise refine_budget (" + now + "): " + took
                               : "raise refine_budget (" + now + ") and lower rate (" +
                                     parameterText(parameters.rate) + " Hz now): " + took;
}

std::string toleranceAdvice(const CycleSetup& setup) {
  return "raise distance_tolerance (" + parameterText(setup.refine.tolerance) + " m now, at most " +
         parameterText(setup.limits.warning_distance) +
         " m): distances of meshes may then be up to that much too small; verdicts by distance do "
         "not "
         "change";
}

std::string hullAdvice(LinkId link, const MonitorSetup& setup) {
  const std::string& name = nameOf(link, setup.setup);
  const std::string triangles = std::to_string(searchedTriangles(link, setup.setup));
  if (isObject(setup.setup.model, link)) {
    return "give object " + name + " a simpler mesh or other shapes in place of its " + triangles +
           " triangles";
  }
  const std::string& file = setup.parameters.shape_rules;
  const std::string rule = "{link: " + name + ", refine: hull}";
  return "if the hull of " + name + " may stand for its " + triangles + " triangles, " +
         (file.empty() ? "write shapes: [" + rule + "] into a file and set shape_rules to its path"
                       : "add the rule " + rule + " to " + file);
}

std::string ignoreAdvice(const Eater& pair, const CycleSetup& setup) {
  const RobotId robot = setup.model.link(pair.a).robot;
  const bool is_one_robot = robot == setup.model.link(pair.b).robot;
  if (isObject(setup.model, pair.a) || isObject(setup.model, pair.b)) {
    return "if " + pairText(pair, setup) +
           " may touch, leave them out by a rule of pair_rules: {a: " + nameOf(pair.a, setup) +
           ", b: " + nameOf(pair.b, setup) + ", check: false}";
  }
  return "if " + pairText(pair, setup) + " never touch" +
         (is_one_robot ? " (rosrun collision_monitor pairs finds out)" : "") +
         ", or are allowed to, leave them out by ignore_pairs: [[" + nameOf(pair.a, setup) + ", " +
         nameOf(pair.b, setup) + "]]" + (is_one_robot ? " or in the SRDF" : "");
}

struct DenseLink {
  LinkId link{};
  double share{0.0};  ///< of the pairs in which it is the densest
};

/// In the order of their pairs.
std::vector<DenseLink> denseLinksOf(const std::vector<Eater>& eaters, const CycleSetup& setup) {
  std::vector<DenseLink> dense;
  for (const Eater& pair : eaters) {
    if (const std::optional<LinkId> link = densestOf(pair, setup)) {
      const auto known = std::find_if(dense.begin(), dense.end(),
                                      [&](const DenseLink& other) { return other.link == *link; });
      if (known == dense.end()) {
        dense.push_back({*link, pair.share});
      } else {
        known->share += pair.share;
      }
    }
  }
  return dense;
}

/// Advice that helps these pairs.
/// @param time [s] as timeOfShort
std::vector<std::string> adviceFor(const MonitorSetup& setup, const std::vector<Eater>& eaters,
                                   double time) {
  constexpr double kMuch = 0.1;  // smaller shares do not justify a rule
  const CycleSetup& cycle = setup.setup;
  std::vector<std::string> advice = {budgetAdvice(setup.parameters, cycle.refine, time)};
  const std::vector<DenseLink> dense_links = denseLinksOf(eaters, cycle);
  if (!dense_links.empty() && cycle.refine.tolerance < cycle.limits.warning_distance) {
    advice.push_back(toleranceAdvice(cycle));
  }
  for (const DenseLink& dense : dense_links) {
    if (dense.share >= kMuch) {
      advice.push_back(hullAdvice(dense.link, setup));
    }
  }
  for (const Eater& pair : eaters) {
    if (pair.share >= kMuch) {
      advice.push_back(ignoreAdvice(pair, cycle));
    }
  }
  return advice;
}

void summarizeBudget(const CycleSetup& setup, const BudgetUse& use,
                     const std::vector<Eater>& eaters, DiagnosticStatusWrapper& status) {
  if (use.short_cycles == 0) {
    status.summary(DiagnosticStatus::OK, use.cycles == 0 ? "no cycle since the last report"
                                                         : "refine_budget sufficed in all cycles");
    return;
  }
  std::string text = "refine_budget did not suffice in " + std::to_string(use.short_cycles) +
                     " of the " + std::to_string(use.cycles) + " cycles since the last report";
  for (std::size_t i = 0; i < eaters.size(); ++i) {
    text += (i == 0 ? "; these pairs took most of its work: " : ", ") + pairText(eaters[i], setup) +
            " (" + percentText(eaters[i].share) + ")";
  }
  status.summary(DiagnosticStatus::WARN, text);
}

}  // namespace

void describeBudget(const MonitorSetup& setup, const BudgetUse& spent,
                    DiagnosticStatusWrapper& status) {
  const CycleSetup& cycle = setup.setup;
  const BudgetUse use = spent.setup == &cycle ? spent : BudgetUse();
  const std::vector<Eater> eaters = eatersOf(cycle, use);
  summarizeBudget(cycle, use, eaters, status);
  status.add("refine_budget", cycle.refine.budget);
  status.add("cycles since the last report", use.cycles);
  status.add("cycles in which it did not suffice", use.short_cycles);
  const double cycles = static_cast<double>(std::max<std::uint64_t>(use.cycles, 1));
  status.add("work of a cycle, mean", fixedText(static_cast<double>(use.work) / cycles, 0));
  status.add("work of a cycle, worst", use.worst);
  std::vector<std::string> most;
  std::transform(eaters.begin(), eaters.end(), std::back_inserter(most), [&](const Eater& pair) {
    return pairText(pair, cycle) + ": " + percentText(pair.share);
  });
  addNumbered("most work", most, status);
  if (use.short_cycles > 0) {
    addNumbered("advice", adviceFor(setup, eaters, timeOfShort(use)), status);
  }
}

}  // namespace collision_monitor
