// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh_depth/mesh_depth.h"

/// The places that a search for the deepest corner passed over, and those that are still open.
/// Together they are the whole mesh.
namespace collision_monitor {

/// Starts from the whole mesh, or from nothing if there is nothing to be deep in.
void restart(bool is_deep_anywhere, KeptDepth::Side& side) noexcept;

/// Opens the places passed over that may be deeper by now.
/// @param least [m] limit above which a place is worth a look
void recall(double least, KeptDepth::Side& side) noexcept;

/// Takes the next open place. @pre there is one
KeptDepth::Place takeNext(KeptDepth::Side& side) noexcept;

/// Puts a place before the open ones. @pre there is room
void putFirst(const KeptDepth::Place& place, KeptDepth::Side& side) noexcept;

/// Makes room for `count` open places. Places passed over are dropped first.
void makeRoom(std::uint32_t count, KeptDepth::Side& side) noexcept;

/// Passes over a place whose limit is up to date. Drops it if there is no room.
void passOver(const KeptDepth::Place& place, KeptDepth::Side& side) noexcept;

}  // namespace collision_monitor
