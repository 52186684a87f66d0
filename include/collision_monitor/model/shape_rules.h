// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/srdf_reader.h"

namespace collision_monitor {

/// What a user says about the shapes of links, in YAML; config/shape_rules.yaml shows all of it.
///
/// A file is a list of rules under `shapes`. Each selects links and sets some fields; of several
/// rules for a link the last one that sets a field decides about it.
///
/// Frames: shapes are placed in the frame of their link; `rpy` turns about fixed axes as in a URDF.
/// Units: metres and radians. A capsule's `length` is the distance between the centers of its caps,
/// a rounded box's `size` that of the box before it is rounded: as a whole each is 2 radius longer.
struct ShapeRulesText {
  std::string source;  ///< what messages call it: a file name
  std::string yaml;    ///< empty: no rules
};

/// Shapes that take the place of fits.
struct GivenShapes {
  std::vector<PosedShape> shapes;  ///< link_from_body in place of geometry_from_body; not empty
  bool is_unproven{false};         ///< the user answers for it that they enclose the link
  std::string where;               ///< "rules.yaml line 12, rule 3"
};

/// What distances to a mesh are refined to where its enclosing shapes come near another link.
enum class RefineGeometry : unsigned char {
  mesh,  ///< its triangles, and what a closed surface holds
  hull,  ///< its convex hull: faster, and never smaller than the mesh
  none,  ///< the enclosing shapes themselves
};

/// What the rules say about one link; nothing where they are silent.
struct LinkRules {
  std::optional<ShapeKinds> kinds;
  std::optional<std::uint32_t> max_shapes;
  std::optional<double> target_overshoot;  ///< [m]
  std::optional<double> padding;           ///< [m]
  std::optional<GivenShapes> given;
  std::optional<RefineGeometry> refine;
};

/// Reads the rules and finds the links they mean.
///
/// Names and patterns (* for any characters, ? for one) are held against a link's name in messages
/// and in its URDF, so that "left/hand" means one link and "hand" that of every robot. A group is
/// one of any robot's SRDF, by its name or behind the robot's prefix. YAML itself has a use for *
/// and
/// ?, so patterns stand in quotes.
///
/// Adds every fault to `report` as an error, each with its line: text that is no YAML, unknown and
/// repeated keys, values of a wrong kind or out of range, names that match nothing, rules
/// without links or without effect. Warnings: no rule at all, a rule whose links have no
/// geometry that could be fitted.
/// @return one a link, by LinkId; after an error, what could be read.
std::vector<LinkRules> readShapeRules(const ShapeRulesText& text, const RobotModel& model,
                                      const std::vector<SrdfPairs>& srdfs, SetupReport& report);

/// Shapes of one link, to be written down.
struct NamedShapes {
  std::string link;
  std::vector<PosedShape> shapes;  ///< as in GivenShapes
  std::string comment;             ///< one line above, "" for none
};

/// Rules that give these shapes, as readShapeRules reads them.
/// Error: numbers have nine digits; buildSetup forgives what this takes from a tight shape.
std::string writeShapeRules(const std::vector<NamedShapes>& links);

}  // namespace collision_monitor
