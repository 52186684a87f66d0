// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/model/document_text.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/srdf_reader.h"

namespace collision_monitor {

/// Shapes that replace fitted shapes.
struct GivenShapes {
  std::vector<PosedShape> shapes;  ///< link_from_body replaces geometry_from_body; not empty
  bool is_unproven{false};         ///< no proof that they enclose the link; the user is responsible
  std::string where;               ///< "rules.yaml line 12, rule 3"
};

/// What distances to a mesh are refined to, where its enclosing shapes are near another link.
enum class RefineGeometry : unsigned char {
  mesh,  ///< its triangles, and the inside of a closed surface
  hull,  ///< its convex hull: faster, and never smaller than the mesh
  none,  ///< the enclosing shapes themselves
};

/// What the rules say about one link; empty fields: no rule sets them.
struct LinkRules {
  std::optional<ShapeKinds> kinds;          ///< of shape that may be fitted
  std::optional<std::uint32_t> max_shapes;  ///< >= 1, of the whole link
  std::optional<double> target_overshoot;   ///< [m]
  std::optional<double> padding;            ///< [m]
  std::optional<GivenShapes> given;         ///< in place of fitted ones
  std::optional<RefineGeometry> refine;     ///< to what distances are refined
};

/// Reads a user's rules about the shapes of links, in YAML, and finds the links that they select.
/// config/shape_rules.yaml shows all of it.
///
/// The text is a list of rules under `shapes`. Each rule selects links and sets some fields. If
/// several rules set the same field of a link, the last one counts.
///
/// Frames: shapes are placed in the frame of their link; `rpy` turns about fixed axes as in a URDF.
/// Units: metres and radians. A capsule's `length` is the distance between the centers of its caps.
/// A rounded box's `size` is that of the box before it is rounded. As a whole each is 2 radius
/// longer.
///
/// Names and patterns (* for any characters, ? for one) match a link's name in messages or in its
/// URDF: "left/hand" selects one link, "hand" selects that link of every robot. A group is one of
/// any robot's SRDF, by its name with or without the robot's prefix. Patterns must be quoted,
/// because * and ? have a meaning in YAML.
///
/// Adds every fault to `report` as an error with its line: text that is no YAML, unknown and
/// repeated keys, values of a wrong kind or out of range, names that match nothing, rules without
/// links or without effect. Warnings: no rule at all; a rule whose links have no geometry to fit.
/// @return one entry per link, by LinkId; after an error, what could be read.
std::vector<LinkRules> readShapeRules(const DocumentText& text, const RobotModel& model,
                                      const std::vector<SrdfPairs>& srdfs, SetupReport& report);

/// Shapes of one link, to be written as rules.
struct NamedShapes {
  std::string link;                ///< the link's name in messages
  std::vector<PosedShape> shapes;  ///< as in GivenShapes
  std::string comment;             ///< one line above the shapes, "" for none
};

/// Rules that give these shapes, in the format that readShapeRules reads.
/// Error: numbers have nine digits; buildSetup tolerates the rounding of a tight shape.
std::string writeShapeRules(const std::vector<NamedShapes>& links);

}  // namespace collision_monitor
