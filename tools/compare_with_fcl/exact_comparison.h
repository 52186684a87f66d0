// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "comparison.h"

namespace collision_monitor {

/// Link verdicts compared with the geometries of the URDF. A link pair in one pose counts once.
struct ExactComparison {
  std::size_t poses{0};
  std::size_t pairs{0};
  std::size_t contacts{0};            ///< true contacts
  std::size_t undecided{0};           ///< either verdict is right (test::Holds)
  std::size_t enclosing_contacts{0};  ///< contacts of enclosing shapes
  std::size_t enclosing_alarms{0};    ///< false ones among them
  std::size_t refined_alarms{0};   ///< false contacts that remain: lower bounds, and marked as such
  std::size_t missed{0};           ///< contacts that the monitor calls clear
  std::size_t wrong_contacts{0};   ///< false contacts that the monitor calls exact or certain
  std::size_t left{0};             ///< element pairs that their cycle's budget left out
  std::size_t complete_wrong{0};   ///< wrong verdicts of cycles without a budget
  std::vector<std::string> wrong;  ///< the first hundred
};

/// Compares in random poses as in compareWithFcl. FCL gives the truth: meshes as BVHModel<OBBRSS>,
/// other geometries as its own shapes. FCL's meshes have no inside; so if it finds no contact, this
/// also tests whether a mesh contains a point of the other geometry. Within kTolerance of distance
/// 0, either verdict is right.
/// @pre the set-up is refined to meshes and has neither padding nor given shapes.
ExactComparison compareExactly(const CycleSetup& setup, const ComparisonOptions& options);

}  // namespace collision_monitor
