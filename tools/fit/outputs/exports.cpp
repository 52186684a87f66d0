// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs/exports.h"

#include "fitting/sphere_trees/build_sphere_tree.h"
#include "outputs/markup_text.h"
#include "outputs/write_urdf.h"
#include "table.h"

namespace collision_monitor::fit_tool {
namespace {

/// "2 capsule; overshoot max 12.3 mm; proven", for all parts together.
std::string commentOn(const FittedLink& link) {
  std::string text;
  for (const FittedPart& part : link.parts) {
    const PartText own = textOf(part);
    text += (text.empty() ? "" : " | ") + own.shapes + "; overshoot max " + own.overshoot_max +
            " mm; " + own.proof;
  }
  return text;
}

bool isProven(const FittedLink& link) {
  for (const FittedPart& part : link.parts) {
    if (!part.figures.is_proven) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string writeRules(const FittedRobot& robot) {
  std::string text =
      "# Shapes in place of fits, in the frames of their links; metres and radians.\n"
      "# Edit and hand it back as the parameter shape_rules of the monitor, or with --rules.\n"
      "shapes:\n";
  const std::string list_head = writeShapeRules({});
  for (const FittedLink& link : robot.links) {
    NamedShapes named{robot.model.link(link.link).name, {}, commentOn(link)};
    for (const FittedPart& part : link.parts) {
      named.shapes.insert(named.shapes.end(), part.shapes.begin(), part.shapes.end());
    }
    text += writeShapeRules({named}).substr(list_head.size());
    if (link.padding > 0.0) {
      text += "    padding: " + fixed(link.padding, 9) + "\n";
    }
    if (!isProven(link)) {
      text += "    unproven: true\n";
    }
  }
  return text;
}

std::vector<LinkSpheres> buildSpheres(const FittedRobot& robot, std::size_t leaves) {
  SphereTreeLimits limits;
  limits.max_leaves = leaves;
  std::vector<LinkSpheres> all;
  for (const FittedLink& fitted : robot.links) {
    const Link& link = robot.model.link(fitted.link);
    LinkSpheres spheres{link.name, {}};
    for (const CollisionElement& element : link.collisions) {
      spheres.trees.push_back(
          placed(buildSphereTree(element.geometry, limits), element.link_from_geometry));
    }
    all.push_back(std::move(spheres));
  }
  return all;
}

std::string writeSphereSrdf(const FittedRobot& robot, const std::vector<LinkSpheres>& spheres,
                            std::uint32_t level) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"" + escaped(robot.model.robots.front().name) +
         "\">\n" + toSrdf(spheres, level) + "</robot>\n";
}

std::string writeShapeUrdf(const FittedRobot& robot, const std::string& urdf_xml) {
  std::vector<LinkShapes> links;
  for (const FittedLink& link : robot.links) {
    links.push_back({robot.model.link(link.link).name, paddedShapesOf(link)});
  }
  return writeUrdf(urdf_xml, links);
}

}  // namespace collision_monitor::fit_tool
