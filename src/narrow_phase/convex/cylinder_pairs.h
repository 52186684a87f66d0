// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "narrow_phase/convex/convex_pairs.h"
#include "narrow_phase/warm_start/cylinder_rows.h"

/// Pairs with a cylinder in and out of CylinderRows.
namespace collision_monitor {

/// Rows by FollowedFeature.
using RowsByFeature = std::array<CylinderRows, kFollowedFeatures>;

/// Fills the row behind the last one, and does not count it.
/// @return of which rows; none for pairs without a cylinder, and those that rows cannot settle.
std::optional<FollowedFeature> fillCylinderRow(const ConvexQuery& query,
                                               RowsByFeature& rows) noexcept;

/// Writes what cylinderFromWarmStart() answers and leaves for the next search.
/// @pre the row is proven.
void answerCylinderRow(FollowedFeature followed, std::size_t row, const CylinderRows& rows,
                       const ConvexQuery& query, ConvexDistance& answer) noexcept;

}  // namespace collision_monitor
