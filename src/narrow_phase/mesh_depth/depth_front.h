// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh_depth/mesh_depth.h"

/// What a search for the deepest corner passed over, and what it has yet to look at: together they
/// are the whole mesh.
namespace collision_monitor {

/// From the whole mesh on, or from nothing where there is nothing to be deep in.
void restart(bool is_deep_anywhere, KeptDepth::Side& side) noexcept;

/// Lets those wait again that may by now be deeper than passed over.
/// @param least [m] limit of what is deep enough to be looked at
void recall(double least, KeptDepth::Side& side) noexcept;

/// Takes the next place that waits. @pre one does
KeptDepth::Place takeNext(KeptDepth::Side& side) noexcept;

/// Puts a place before those that wait. @pre there is room
void putFirst(const KeptDepth::Place& place, KeptDepth::Side& side) noexcept;

/// Makes room for that many places that wait; what is passed over goes first.
void makeRoom(std::uint32_t count, KeptDepth::Side& side) noexcept;

/// Passes over a place whose limit is up to date; drops it where there is no room.
void passOver(const KeptDepth::Place& place, KeptDepth::Side& side) noexcept;

}  // namespace collision_monitor
