// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pipeline/world/prepare_object.h"

namespace collision_monitor {

/// What addWorld needs of a set-up of robots: all but the tables of pairs and the triangles of the
/// URDF's meshes, for which bodies and elements stand.
CycleSetup withoutPairs(const CycleSetup& robots);

/// The set-up of robots with objects beside them. Each object is a link, so everything that is true
/// of links is true of objects: verdicts, gradients, times, and UNKNOWN without a pose. It is
/// joined by a fixed joint to the link that it is attached to or whose frame carries it, or else to
/// a link without shapes for the tf frame that carries it. Each such frame is a robot of its own
/// (Robot::is_world), with stamps of its own. Objects joined to links of robots form one more.
///
/// Links, bodies, elements and pairs of links of the robots keep their order, and ids of links,
/// bodies and elements stay the same. Equal worlds give equal set-ups. Very many objects of one
/// carrier are sorted by place, others by name.
///
/// Rules of the robots stay as they are; see withPairRules. Groups of objects join setup.srdfs.
///
/// Pairs: every object with every link that has shapes, except its touch links, and of an attached
/// object its link and the links rigidly joined to it. An attached object with every other object,
/// except those that move with it. Two objects that are not attached form no pair.
///
/// Errors: more pairs than memory has room for, which is found before anything is made of them.
/// @param world_frame of objects without frame
/// @param robots a set-up without objects, or what withoutPairs left of it
/// @param prepared those of `world`
/// @pre the world passed applyChanges for these robots
/// @throws SetupError, Interrupted
CycleSetup addWorld(const CycleSetup& robots, const World& world, const PreparedObjects& prepared,
                    const std::string& world_frame);

/// Reads the rules for pairs again, since they may name objects, and applies them to the set-up.
/// @param idle a warning where objects that rules name may have gone
/// @throws SetupError, Interrupted
void applyRulesText(const DocumentText& text, IdleRule idle, CycleSetup& setup);

}  // namespace collision_monitor
