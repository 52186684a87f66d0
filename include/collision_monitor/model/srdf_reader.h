// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// A `<group>` and what stands in it; linksOf says which links that is.
struct LinkGroup {
  struct Chain {
    LinkId base{};
    LinkId tip{};
  };
  std::string name;           ///< as written, without the robot's prefix
  std::vector<LinkId> links;  ///< of `<link>` and `<joint>`
  std::vector<Chain> chains;
  std::vector<std::size_t> groups;  ///< indices into SrdfPairs::groups
};

/// What an SRDF says about pairs and groups, with names resolved to links of the model.
struct SrdfPairs {
  struct Entry {
    LinkId a{};
    LinkId b{};
    std::string reason;  ///< the attribute as written, may be empty
  };
  RobotId robot{};
  std::vector<Entry> disabled;              ///< `<disable_collisions>`
  std::vector<Entry> enabled;               ///< `<enable_collisions>`
  std::vector<LinkId> disabled_by_default;  ///< `<disable_default_collisions>`
  std::vector<LinkGroup> groups;            ///< `<group>`, in the order of the file
};

/// Reads the SRDF of one robot of the model, `description.srdf_xml`. Names in it are those
/// of the URDF; the robot's prefix is put before them.
///
/// Groups hold what MoveIt moves with them: of a `<joint>` its child link, of a `<chain>` the
/// links from base_link to tip_link without base_link itself, or, where base_link is no ancestor of
/// tip_link, all from one over the link at which they meet to the other; of a `<group>` its links,
/// wherever in the file it stands. A `<virtual_joint>` stands for the link that it moves.
///
/// Warnings: links that are unknown, listed together with their lines, which are ignored: SRDFs are
/// shared by variants of a robot, and what they fail to disable is checked; the same for names in
/// groups; pairs that are both enabled and disabled; a link with itself.
/// Errors: XML that cannot be parsed, and a line without its links; if `description.is_strict`,
/// unknown names, too.
/// Limits: after an error the result holds what could be read. If `model` does not have the
/// robot, because its URDF could not be read, only the XML is checked.
SrdfPairs readSrdf(const RobotDescription& description, RobotId robot, const RobotModel& model,
                   SetupReport& report);

/// The links that a group holds, sorted, each once: also those of groups in it, and in these. A
/// circle of groups holds what its members hold.
std::vector<LinkId> linksOf(const std::vector<LinkGroup>& groups, std::size_t group,
                            const RobotModel& model);

}  // namespace collision_monitor
