// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fit_robot.h"

#include <algorithm>

#include "collision_monitor/fitting/fit_parts.h"
#include "measure_fit.h"
#include "model/rules/link_selection.h"
#include "pictures/surface_mesh.h"
#include "pipeline/fits/open_meshes.h"

namespace collision_monitor::fit_tool {
namespace {

std::vector<SrdfPairs> readGroups(const RobotDescription& description, const RobotModel& model,
                                  SetupReport& report) {
  if (description.srdf_xml.empty()) {
    return {};
  }
  return {readSrdf(description, RobotId{0}, model, report)};
}

/// Removes the geometry of all other links, so that nothing is fitted there.
void keepOnly(const std::string& pattern, RobotModel& model, std::vector<LinkRules>& rules,
              SetupReport& report) {
  const std::vector<LinkId> chosen = findMatching(pattern, model);
  if (chosen.empty()) {
    report.errors.push_back({"option --link", "no link fits '" + pattern + "'",
                             "a name or pattern (* any characters, ? one) of " + linkNames(model)});
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (std::find(chosen.begin(), chosen.end(), idAt<LinkId>(i)) == chosen.end()) {
      model.links[i].collisions.clear();
      rules[i] = LinkRules();
    }
  }
}

std::size_t trianglesOf(const Geometry& geometry) {
  const auto* mesh = std::get_if<TriangleMesh>(&geometry);
  return mesh == nullptr ? 0 : mesh->triangles.size();
}

PosedShape inLink(const Pose& link_from_geometry, const Enclosure& enclosure) {
  return {enclosure.shape, link_from_geometry * enclosure.geometry_from_body};
}

/// Adds the shapes and the figures common to all parts, but neither proof nor overshoot.
void addShapes(const Link& link, const Pose& link_from_geometry,
               const std::vector<Enclosure>& enclosures, FittedPart& part) {
  for (const Enclosure& enclosure : enclosures) {
    part.shapes.push_back(inLink(link_from_geometry, enclosure));
    part.figures.widening = std::max(part.figures.widening, enclosure.widening);
  }
  for (const std::size_t element : part.elements) {
    part.figures.triangles += trianglesOf(link.collisions[element].geometry);
    part.figures.hull_volume += hullVolumeOf(link.collisions[element].geometry);
  }
  part.figures.shape_volume = unionVolumeOf(part.shapes);
  part.inner = innerShapesOf(link, part.elements);
}

FittedPart fittedPart(const Link& link, std::size_t element, const Fit& fit) {
  const CollisionElement& collision = link.collisions[element];
  FittedPart part;
  part.name = collision.name;
  part.elements = {element};
  addShapes(link, collision.link_from_geometry, fit.shapes, part);
  part.figures.overshoot = fit.overshoot;
  // Proven again, so that the table does not rely on earlier claims.
  part.figures.is_proven = provenExcess(collision.geometry, fit) <= 0.0;
  return part;
}

FittedPart givenPart(const Link& link, const LinkFit& fit) {
  FittedPart part;
  part.name = "given";
  for (std::size_t i = 0; i < link.collisions.size(); ++i) {
    part.elements.push_back(i);
  }
  addShapes(link, Pose(), fit.given, part);
  if (!part.elements.empty()) {
    part.figures.overshoot = unionOvershootOf(part.shapes, surfaceMeshOf(link, part.elements));
  }
  part.figures.is_proven = fit.is_proven;
  return part;
}

}  // namespace

FittedRobot fitRobot(const RobotDescription& description, const ResourceLoader& load_resource,
                     const FitRequest& request, const FitProgress& progress) {
  FittedRobot robot;
  robot.model = readRobots({description}, load_resource, robot.report);
  const std::vector<SrdfPairs> srdfs = readGroups(description, robot.model, robot.report);
  throwIfErrors(robot.report);
  FitSettings settings{request.limits, request.padding,
                       readShapeRules(request.rules, robot.model, srdfs, robot.report),
                       request.cache};
  settings.rules.resize(robot.model.links.size());
  if (!request.link_pattern.empty()) {
    keepOnly(request.link_pattern, robot.model, settings.rules, robot.report);
  }
  if (const auto warning = warnOfOpenMeshes(robot.model)) {
    robot.report.warnings.push_back(*warning);
  }
  throwIfErrors(robot.report);

  const std::vector<LinkFit> fits = fitLinks(robot.model, settings, progress, robot.report);
  throwIfErrors(robot.report);
  for (const LinkFit& fit : fits) {
    const Link& link = robot.model.link(fit.link);
    FittedLink fitted{fit.link, fit.source, fit.seconds, fit.padding, {}};
    if (fit.source == FitSource::given) {
      fitted.parts.push_back(givenPart(link, fit));
    }
    for (std::size_t i = 0; i < fit.fits.size(); ++i) {
      fitted.parts.push_back(fittedPart(link, i, fit.fits[i]));
    }
    robot.links.push_back(std::move(fitted));
  }
  return robot;
}

std::vector<PosedShape> paddedShapesOf(const FittedLink& link) {
  std::vector<PosedShape> shapes;
  for (const FittedPart& part : link.parts) {
    for (const PosedShape& shape : part.shapes) {
      shapes.push_back({link.padding > 0.0 ? grown(shape.shape, link.padding) : shape.shape,
                        shape.geometry_from_body});
    }
  }
  return shapes;
}

}  // namespace collision_monitor::fit_tool
