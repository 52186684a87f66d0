// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/pair_rows.h"

/// The routines of distance.h measure again what batched kernels are not sure of.
namespace collision_monitor {

/// As distanceBetween; NaN for poses that are not finite.
SignedDistance plainDistance(const Core& a, const Pose& world_from_a, const Core& b,
                             const Pose& world_from_b) noexcept;

/// A pose with this z axis, for segments. Its other axes are arbitrary.
Pose poseAlong(const Eigen::Vector3d& axis_z, const Eigen::Vector3d& translation) noexcept;

/// A row read back from columns that are `stride` numbers apart; `first` is its first number.
struct PosedCore {
  Core core;
  Pose pose;
};
PosedCore readCore(CoreKind kind, const double* first, std::size_t stride) noexcept;

/// Measures the rows whose distance is NaN.
void finishRows(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) noexcept;

}  // namespace collision_monitor
