// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/pipeline/fit_links.h"

/// The program `fit`: encloses the links of a robot, says how well, and writes the shapes down.
namespace collision_monitor::fit_tool {

/// What is to be fitted, as far as it is the user's choice.
struct FitRequest {
  FitLimits limits;
  double padding{0.0};          ///< [m]
  ShapeRulesText rules;         ///< empty for none
  std::filesystem::path cache;  ///< empty for none
  std::string link_pattern;     ///< only links with such a name; empty for all
};

/// How well shapes enclose geometry. Units: metres, cubic metres.
struct Figures {
  std::size_t triangles{0};
  double hull_volume{0.0};   ///< of the convex hulls, each by itself; 0 where it is flat
  double shape_volume{0.0};  ///< of the union of the shapes
  Overshoot overshoot;       ///< of the union of the shapes
  bool is_proven{false};     ///< that the union of the shapes encloses
  double widening{0.0};      ///< the largest that the proof asked for
};

/// A collision element and its shapes, or all those of a link whose shapes are given.
struct FittedPart {
  std::string name;                   ///< of the collision element, or "given"
  std::vector<std::size_t> elements;  ///< into Link::collisions
  std::vector<PosedShape> shapes;     ///< in the link frame in place of the geometry's; no padding
  InnerShapes inner;                  ///< in the link frame; none, as in an open mesh
  Figures figures;
};

struct FittedLink {
  LinkId link{};
  FitSource source{FitSource::fitted};
  double seconds{0.0};  ///< what fitting took, or loading and proving
  double padding{0.0};  ///< [m] that the monitor adds to each shape
  std::vector<FittedPart> parts;
};

struct FittedRobot {
  RobotModel model;
  std::vector<FittedLink> links;  ///< that were chosen and have shapes, in order of link
  SetupReport report;             ///< warnings only
};

/// Reads a robot, fits its links and measures the fits.
/// @param progress may be empty
/// @throws SetupError with every fault found
FittedRobot fitRobot(const RobotDescription& description, const ResourceLoader& load_resource,
                     const FitRequest& request, const FitProgress& progress);

/// All shapes of a link in the link frame as the monitor uses them: with padding.
std::vector<PosedShape> paddedShapesOf(const FittedLink& link);

}  // namespace collision_monitor::fit_tool
