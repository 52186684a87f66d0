// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "comparison.h"

namespace collision_monitor {

/// Verdicts about links against the geometries of the URDF. A pair of links in one pose counts
/// once.
struct ExactComparison {
  std::size_t poses{0};
  std::size_t pairs{0};
  std::size_t contacts{0};            ///< in truth
  std::size_t undecided{0};           ///< either answer is right (test::Holds)
  std::size_t enclosing_contacts{0};  ///< of enclosing shapes
  std::size_t enclosing_alarms{0};    ///< of these, false
  std::size_t refined_alarms{0};      ///< false ones that are left: lower bounds, as they say
  std::size_t missed{0};              ///< contacts that the monitor calls clear
  std::size_t wrong_contacts{0};      ///< called exact or certain, and none
  std::size_t left{0};                ///< pairs of elements beyond the budget of their cycle
  std::size_t complete_wrong{0};      ///< verdicts of cycles without a budget that are not true
  std::vector<std::string> wrong;     ///< the first hundred
};

/// Random joint values as in compareWithFcl. The truth is FCL's: meshes as BVHModel<OBBRSS>, the
/// rest as its shapes; and where it sees no contact, whether a mesh holds a point of the
/// other, for FCL's meshes have no inside. Distances within kTolerance of 0 are right either way.
/// @pre the set-up is refined to meshes and has neither padding nor given shapes.
ExactComparison compareExactly(const CycleSetup& setup, const ComparisonOptions& options);

}  // namespace collision_monitor
