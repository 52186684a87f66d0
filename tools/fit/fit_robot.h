// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/pipeline/fit_links.h"

/// The program `fit`: encloses a robot's links, reports how well, and writes the shapes to files.
namespace collision_monitor::fit_tool {

/// The user's choices for a fit.
struct FitRequest {
  FitLimits limits;
  double padding{0.0};          ///< [m]
  DocumentText rules;           ///< empty for none
  std::filesystem::path cache;  ///< empty for none
  std::string link_pattern;     ///< only links whose name matches; empty for all
};

/// How well shapes enclose geometry. Units: metres, cubic metres.
struct Figures {
  std::size_t triangles{0};
  double hull_volume{0.0};   ///< sum of the convex hulls' volumes; 0 where a hull is flat
  double shape_volume{0.0};  ///< of the union of the shapes
  Overshoot overshoot;       ///< of the union of the shapes
  bool is_proven{false};     ///< whether the union of the shapes is proven to enclose the geometry
  double widening{0.0};      ///< the largest widening that the proof needed
};

/// A collision element with its shapes; or all elements of a link whose shapes are given.
struct FittedPart {
  std::string name;                   ///< of the collision element, or "given"
  std::vector<std::size_t> elements;  ///< indices into Link::collisions
  std::vector<PosedShape> shapes;     ///< in the link frame, not the geometry's; without padding
  InnerShapes inner;                  ///< in the link frame; none for an open mesh, for example
  Figures figures;
};

struct FittedLink {
  LinkId link{};
  FitSource source{FitSource::fitted};
  double seconds{0.0};  ///< [s] time to fit, or to load and prove
  double padding{0.0};  ///< [m] the monitor adds it to each shape
  std::vector<FittedPart> parts;
};

struct FittedRobot {
  RobotModel model;
  std::vector<FittedLink> links;  ///< the selected links that have shapes, ordered by link
  SetupReport report;             ///< warnings only
};

/// Reads a robot, fits its links and measures the fits.
/// @param progress may be empty
/// @throws SetupError with every fault found
FittedRobot fitRobot(const RobotDescription& description, const ResourceLoader& load_resource,
                     const FitRequest& request, const FitProgress& progress);

/// All shapes of a link, in the link frame and with padding, as the monitor uses them.
std::vector<PosedShape> paddedShapesOf(const FittedLink& link);

}  // namespace collision_monitor::fit_tool
