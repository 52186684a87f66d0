// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// A `<group>` and its members as listed. linksOf computes the links that it holds.
struct LinkGroup {
  /// `<chain>`: the links from one to the other.
  struct Chain {
    LinkId base{};  ///< where it starts
    LinkId tip{};   ///< where it ends
  };
  std::string name;                 ///< as written, without the robot's prefix
  std::vector<LinkId> links;        ///< from `<link>` and `<joint>`
  std::vector<Chain> chains;        ///< from `<chain>`
  std::vector<std::size_t> groups;  ///< indices into SrdfPairs::groups
};

/// What an SRDF says about pairs and groups, with names resolved to links of the model.
struct SrdfPairs {
  /// One line about two links.
  struct Entry {
    LinkId a{};          ///< in the order of the line
    LinkId b{};          ///< in the order of the line
    std::string reason;  ///< the attribute as written; may be empty
    int line{0};         ///< of the SRDF
  };
  /// `<disable_default_collisions>`.
  struct Default {
    LinkId link{};  ///< of which all pairs are disabled
    int line{0};    ///< of the SRDF
  };
  /// `<link_sphere_approximation>`, in the frame of the link.
  struct Spheres {
    LinkId link{};                    ///< the link that they stand for
    std::vector<PosedShape> spheres;  ///< in the order of the file
    int line{0};                      ///< of the SRDF
  };
  std::string source{};                      ///< the name of the SRDF in messages
  RobotId robot{};                           ///< whose SRDF it is
  std::vector<Entry> disabled;               ///< `<disable_collisions>`
  std::vector<Entry> enabled;                ///< `<enable_collisions>`
  std::vector<Default> disabled_by_default;  ///< in the order of the file
  std::vector<LinkGroup> groups;             ///< `<group>`, in the order of the file
  std::vector<Spheres> spheres;              ///< of links that have some
};

/// Reads the SRDF of one robot of the model, `description.srdf_xml`. Names in an SRDF are those of
/// the URDF; this function adds the robot's prefix.
///
/// Groups hold what MoveIt moves with them. A `<joint>` adds its child link. A `<chain>` adds the
/// links from base_link to tip_link, without base_link. If base_link is not an ancestor of
/// tip_link, the chain adds all links from one to the other, through their lowest common ancestor.
/// A `<group>` adds its links, wherever it is in the file. A `<virtual_joint>` stands for the link
/// that it moves.
///
/// Virtual joints and passive joints decide no pair: tf and joint states place links. Spheres of
/// radius 0 are left out of approximations.
///
/// Warnings: unknown links and unknown names in groups, listed with their lines and ignored
/// (variants of a robot share SRDFs; pairs that are thus not disabled are checked); pairs that are
/// both enabled and disabled; a pair of a link with itself.
/// Errors: XML that cannot be parsed; a line without its links; unknown names if
/// `description.is_strict`.
/// Limits: after an error the result holds what could be read. If `model` lacks the robot because
/// its URDF could not be read, only the XML is checked.
SrdfPairs readSrdf(const RobotDescription& description, RobotId robot, const RobotModel& model,
                   SetupReport& report);

/// The links that a group holds, sorted and unique, including those of nested groups. Groups that
/// contain each other all hold the links of all of them.
std::vector<LinkId> linksOf(const std::vector<LinkGroup>& groups, std::size_t group,
                            const RobotModel& model);

}  // namespace collision_monitor
