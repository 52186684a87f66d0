// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/fit_links.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "collision_monitor/fitting/covering.h"
#include "collision_monitor/geometry/interruption.h"
#include "pipeline/fill_hollow.h"
#include "pipeline/fit_cache.h"

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

/// Shapes that the user gives: proven, or the user's word for it, or an error.
void takeGiven(const Link& link, const GivenShapes& given, LinkFit& fit, SetupReport& report) {
  std::vector<PlacedGeometry> geometries;
  for (const CollisionElement& element : link.collisions) {
    geometries.push_back({element.link_from_geometry, &element.geometry});
  }
  const Covering covering = proveCovering(geometries, given.shapes, kGivenTolerance);
  fit.source = FitSource::given;
  fit.is_proven = covering.is_proven;
  for (const PosedShape& shape : given.shapes) {
    Enclosure enclosure;
    enclosure.shape = grown(shape.shape, covering.widening);
    enclosure.geometry_from_body = shape.geometry_from_body;
    enclosure.widening = covering.widening;
    enclosure.overshoot = {std::nan(""), std::nan(""), std::nan("")};
    fit.given.push_back(enclosure);
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

/// Each geometry is checked by itself once the link as a whole failed, to name the faulty one.
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

void fitLink(const Link& link, const FitLimits& limits, FitCache& cache, LinkFit& fit) {
  std::vector<Geometry> geometries;
  for (const CollisionElement& element : link.collisions) {
    geometries.push_back(element.geometry);
  }
  const std::string key = fitKey(geometries, limits);
  if (const std::vector<Fit>* repeated = cache.findRepeated(key)) {
    fit.source = FitSource::repeated;
    fit.fits = *repeated;
    return;
  }
  if (std::optional<std::vector<Fit>> loaded = cache.load(key, geometries)) {
    fit.source = FitSource::cached;
    fit.fits = std::move(*loaded);
  } else {
    fit.source = FitSource::fitted;
    fit.fits = fitGeometries(geometries, limits);
  }
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    fillHollow(geometries[i], limits.kinds, fit.fits[i]);
  }
  cache.keep(key, fit.fits, fit.source == FitSource::cached);
}

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
  FitCache cache(settings.cache_directory);
  std::vector<LinkFit> all;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    throwIfInterrupted();
    const Link& link = model.links[i];
    const LinkRules rules = settings.rules.empty() ? LinkRules() : settings.rules[i];
    if (link.collisions.empty() && !rules.given) {
      continue;
    }
    if (progress) {
      progress(link.name, i, model.links.size());
    }
    LinkFit fit;
    fit.link = idAt<LinkId>(i);
    fit.padding = rules.padding.value_or(settings.padding);
    const FitLimits limits = limitsFor(settings, rules);
    try {
      if (rules.given) {
        takeGiven(link, *rules.given, fit, report);
      } else {
        fitLink(link, limits, cache, fit);
      }
    } catch (const std::invalid_argument& fault) {
      reportFault(link, limits, fault.what(), report);
      continue;
    }
    all.push_back(std::move(fit));
  }
  if (progress) {
    progress("", model.links.size(), model.links.size());
  }
  reportCache(settings.cache_directory, cache, report);
  return all;
}

}  // namespace collision_monitor
