// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "narrow_phase/convex/convex_pairs.h"
#include "narrow_phase/warm_start/cylinder_rows.h"

/// Moves pairs with a cylinder into CylinderRows and out of them.
namespace collision_monitor {

/// Rows by FollowedFeature.
using RowsByFeature = std::array<CylinderRows, kFollowedFeatures>;

/// Fills the row after the last one without counting it.
/// @return the feature of the rows; none for pairs without a cylinder or that rows cannot settle.
std::optional<FollowedFeature> fillCylinderRow(const ConvexQuery& query,
                                               RowsByFeature& rows) noexcept;

/// Writes the answer and the warm start of cylinderFromWarmStart().
/// @pre the row is proven.
void answerCylinderRow(FollowedFeature followed, std::size_t row, const CylinderRows& rows,
                       const ConvexQuery& query, ConvexDistance& answer) noexcept;

}  // namespace collision_monitor
