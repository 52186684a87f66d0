// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/warm_start/proof_rows.h"

/// Cylinders and other cores that are apart, many pairs at once: the first step of
/// cylinderFromWarmStart in columns. Every row does what follow_feature.h does, in the same order.
namespace collision_monitor {

/// The feature of the other core that is followed.
enum class FollowedFeature : unsigned char { corner, edge, rim };

constexpr std::size_t kFollowedFeatures = 3;

/// The corner of a sphere's core. Lanes read four numbers at once.
constexpr double kOriginOfCore[4] = {};

/// Columns of CylinderRows, for the cores. Frames: world unless said otherwise.
namespace closest {
enum Column : std::size_t {
  distance,                      ///< [m] NaN: not proven
  on_cylinder,                   ///< x, y, z, in the cylinder's frame
  on_other = on_cylinder + 3,    ///< of a rim: in its cylinder's frame
  point = on_other + 3,          ///< on the cylinder
  normal = point + 3,            ///< unit, away from the cylinder
  size = normal + 3,             ///< as PlacedPair::size; before: the bounding radii
  radius,                        ///< [m] of the cylinder
  half_length,                   ///< [m] of the cylinder
  radius_of_other,               ///< [m] of a rim
  half_length_of_other,          ///< [m] of a rim's cylinder
  direction_in_other,            ///< minus the normal, in the other's frame
  gap = direction_in_other + 3,  ///< [m] from the cylinder's plane to the other's origin
  reach_of_other,                ///< [m] from the other's origin towards the cylinder
  may_be_level,                  ///< 0 or 1, of the cylinder; after: of both
  count
};
}  // namespace closest

/// Pairs that follow the same feature.
struct CylinderRows {
  std::size_t count;  ///< at most kProofRows
  std::array<ProofSide, kProofRows> cylinder;
  std::array<ProofSide, kProofRows> other;
  /// Where the last search ended, each in its frame. They point into ConvexWarmStart::ends: the
  /// second corner of an edge is one Ends after the first.
  std::array<const double*, kProofRows> last_on_cylinder;
  std::array<const double*, kProofRows> last_on_other;
  std::array<std::size_t, kProofRows> query;  ///< of the caller
  std::array<bool, kProofRows> is_swapped;    ///< the cylinder is B
  alignas(64) std::array<std::array<double, kProofRows>, closest::count> at;
};

/// Fills the columns, and `vertex` of `other`. Rows that are not proven are left to
/// cylinderFromWarmStart: all of its further steps, edges that are nearest at an end, and features
/// that may be level.
/// @pre there is a row; the columns from `size` to `half_length_of_other` are filled.
void proveCylinderRows(FollowedFeature followed, CylinderRows& rows) noexcept;

}  // namespace collision_monitor
