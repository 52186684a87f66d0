// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/fit_links.h"

#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "fitting/proofs/covering.h"
#include "geometry/all_cores.h"
#include "geometry/interruption.h"
#include "pipeline/fits/fill_hollow.h"
#include "pipeline/fits/fit_cache.h"

namespace collision_monitor {
namespace {

FitLimits limitsFor(const FitSettings& settings, const LinkRules& rules) {
  FitLimits limits = settings.limits;
  limits.kinds = rules.kinds.value_or(limits.kinds);
  limits.max_shapes = rules.max_shapes.value_or(limits.max_shapes);
  limits.target_overshoot = rules.target_overshoot.value_or(limits.target_overshoot);
  return limits;
}

/// "the surface of collision 'tube' at (0.1, 0, 0.25) is 3.21 mm outside"
std::string describe(const Covering& covering, const Link& link) {
  std::ostringstream text;
  text.precision(4);
  const Eigen::Vector3d& point = covering.farthest;
  text << "collision '" << link.collisions[covering.geometry].name << "' is "
       << 1e3 * covering.excess << " mm outside at (" << point.x() << ", " << point.y() << ", "
       << point.z() << ")";
  return text.str();
}

/// Takes given shapes: proven, or unproven by the rule, or an error.
void takeGiven(const Link& link, const GivenShapes& given, LinkFit& fit, SetupReport& report) {
  std::vector<PlacedGeometry> geometries;
  for (const CollisionElement& element : link.collisions) {
    geometries.push_back({element.link_from_geometry, &element.geometry});
  }
  const Covering covering = proveCovering(geometries, given.shapes, kGivenTolerance);
  fit.source = FitSource::given;
  fit.is_proven = covering.is_proven;
  for (const PosedShape& shape : given.shapes) {
    const Overshoot unknown{std::nan(""), std::nan(""), std::nan("")};
    fit.given.push_back({grown(shape.shape, covering.widening), shape.geometry_from_body, unknown,
                         covering.widening, false});
  }
  if (covering.is_proven) {
    return;
  }
  const std::string where = given.where + ", shapes of link '" + link.name + "'";
  const std::string found = describe(covering, link);
  if (given.is_unproven) {
    report.warnings.push_back({where, found, "",
                               "as 'unproven: true' allows: the link may be nearer than its "
                               "distances say"});
  } else {
    report.errors.push_back({where, found,
                             "shapes that enclose the geometry of the link, or 'unproven: true' in "
                             "the rule"});
  }
}

/// Checks each geometry alone after the fit of a link has failed, to name the faulty one.
void reportFault(const Link& link, const FitLimits& limits, const std::string& fault,
                 SetupReport& report) {
  const std::string accepted = "geometry that a shape can enclose";
  const std::size_t before = report.errors.size();
  for (const CollisionElement& element : link.collisions) {
    try {
      encloseTightly(element.geometry, limits.kinds);
    } catch (const std::invalid_argument& own_fault) {
      report.errors.push_back({"link '" + link.name + "', collision '" + element.name + "'",
                               own_fault.what(), accepted});
    }
  }
  if (report.errors.size() == before) {
    report.errors.push_back({"link '" + link.name + "'", fault, accepted});
  }
}

/// @return false, after an error, if the geometry cannot be used.
bool takeSoundGiven(const Link& link, const FitLimits& limits, const GivenShapes& given,
                    LinkFit& fit, SetupReport& report) {
  try {
    takeGiven(link, given, fit, report);
    return true;
  } catch (const std::invalid_argument& fault) {
    reportFault(link, limits, fault.what(), report);
    return false;
  }
}

/// A link whose shapes are fitted to its geometries.
struct FitTask {
  const Link* link{nullptr};
  std::size_t number{0};  ///< position of the link among links
  std::size_t place{0};   ///< index into all fits
  FitLimits limits;
  std::string key;
  std::string fault;  ///< why there are no shapes
};

std::vector<Geometry> geometriesOf(const Link& link) {
  std::vector<Geometry> geometries;
  for (const CollisionElement& element : link.collisions) {
    geometries.push_back(element.geometry);
  }
  return geometries;
}

void fitLink(FitTask& task, FitCache& cache, LinkFit& fit) {
  const std::vector<Geometry> geometries = geometriesOf(*task.link);
  if (std::optional<std::vector<Fit>> loaded = cache.load(task.key, geometries)) {
    fit.source = FitSource::cached;
    fit.fits = std::move(*loaded);
    cache.keep(task.key, fit.fits, true);
    return;
  }
  try {
    fit.source = FitSource::fitted;
    fit.fits = fitGeometries(geometries, task.limits);
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      fillHollow(geometries[i], task.limits.kinds, fit.fits[i]);
      fit.fits[i].inner = inscribeShapes(geometries[i]);
    }
    cache.keep(task.key, fit.fits, false);
  } catch (const std::invalid_argument& fault) {
    task.fault = fault.what();
  }
}

/// Fits equal links once, on all processors, each link on one.
class LinkFitter {
  using Clock = std::chrono::steady_clock;

 public:
  LinkFitter(const FitSettings& settings, const FitProgress& progress, std::size_t total)
      : cache_(settings.cache_directory), progress_(progress), total_(total) {}

  void fit(std::vector<FitTask>& tasks, std::vector<LinkFit>& fits) {
    forEachOnAllCores(tasks.size(), [&](std::size_t i) {
      tasks[i].key = fitKey(geometriesOf(*tasks[i].link), tasks[i].limits);
    });
    std::map<std::string, std::size_t> first_of;
    std::vector<std::size_t> first;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (first_of.emplace(tasks[i].key, i).second) {
        first.push_back(i);
      }
    }
    forEachOnAllCores(first.size(), [&](std::size_t i) {
      FitTask& task = tasks[first[i]];
      tellUpTo(first[i], tasks);
      const auto start = Clock::now();
      fitLink(task, cache_, fits[task.place]);
      fits[task.place].seconds = std::chrono::duration<double>(Clock::now() - start).count();
    });
    if (!tasks.empty()) {
      tellUpTo(tasks.size() - 1, tasks);
    }
    for (FitTask& task : tasks) {
      const FitTask& like = tasks[first_of.at(task.key)];
      if (like.place != task.place) {
        task.fault = like.fault;
        fits[task.place].fits = fits[like.place].fits;
        fits[task.place].source = FitSource::repeated;
      }
    }
  }

  const FitCache& cache() const { return cache_; }

 private:
  /// Reports progress in order of links, whatever the order in which threads reach them.
  void tellUpTo(std::size_t last, const std::vector<FitTask>& tasks) {
    const std::lock_guard<std::mutex> lock(telling_);
    for (; progress_ && told_ <= last; ++told_) {
      progress_(tasks[told_].link->name, tasks[told_].number, total_);
    }
  }

  FitCache cache_;
  const FitProgress& progress_;
  std::size_t total_;
  std::size_t told_{0};  ///< number of tasks reported
  std::mutex telling_;
};

void reportCache(const std::filesystem::path& directory, const FitCache& cache,
                 SetupReport& report) {
  const std::string where = "cache of fits " + directory.string();
  if (cache.rejectedCount() > 0) {
    report.warnings.push_back({where,
                               std::to_string(cache.rejectedCount()) +
                                   " files that are damaged, not regular or prove nothing",
                               "", "these links are fitted anew"});
  }
  if (!cache.writeFault().empty()) {
    report.warnings.push_back({where, "cannot be written: " + cache.writeFault(), "",
                               "every start fits anew until it can"});
  }
}

}  // namespace

const char* nameOf(FitSource source) noexcept {
  switch (source) {
    case FitSource::fitted:
      return "fitted";
    case FitSource::cached:
      return "cached";
    case FitSource::repeated:
      return "repeated";
    case FitSource::given:
      return "given";
  }
  return "unknown";
}

std::vector<LinkFit> fitLinks(const RobotModel& model, const FitSettings& settings,
                              const FitProgress& progress, SetupReport& report) {
  std::vector<LinkFit> all;
  std::vector<FitTask> tasks;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    throwIfInterrupted();
    const Link& link = model.links[i];
    const LinkRules rules = settings.rules.empty() ? LinkRules() : settings.rules[i];
    if (link.collisions.empty() && !rules.given) {
      continue;
    }
    LinkFit fit;
    fit.link = idAt<LinkId>(i);
    fit.padding = rules.padding.value_or(settings.padding);
    const FitLimits limits = limitsFor(settings, rules);
    if (!rules.given) {
      tasks.push_back({&link, i, all.size(), limits, {}, {}});
    } else if (!takeSoundGiven(link, limits, *rules.given, fit, report)) {
      continue;
    }
    all.push_back(std::move(fit));
  }
  LinkFitter fitter(settings, progress, model.links.size());
  fitter.fit(tasks, all);
  std::vector<bool> is_faulty(all.size(), false);
  for (const FitTask& task : tasks) {
    if (!task.fault.empty()) {
      reportFault(*task.link, task.limits, task.fault, report);
      is_faulty[task.place] = true;
    }
  }
  std::vector<LinkFit> fits;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_faulty[i]) {
      fits.push_back(std::move(all[i]));
    }
  }
  if (progress) {
    progress("", model.links.size(), model.links.size());
  }
  reportCache(settings.cache_directory, fitter.cache(), report);
  return fits;
}

}  // namespace collision_monitor
