// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "peers/placed_states.h"
#include "pipeline/states/check_states.h"

namespace collision_monitor::test {

/// Whether links touch; either: they touch within FCL's tolerance, or the inside of an open mesh
/// is a matter of definition.
enum class Truth : unsigned char { clear, either, contact };

/// How verdicts of pairs of links compare with FCL's. The reference decides where they differ.
struct SceneVerdicts {
  std::size_t compared{0};
  std::size_t contacts{0};    ///< of these, by us
  std::size_t different{0};   ///< from FCL's
  std::size_t touching{0};    ///< of the different ones: either is right
  std::size_t inside{0};      ///< of the different ones: inside a mesh, which FCL does not see
  std::size_t fcl_wrong{0};   ///< of the different ones, or FCL has no answer
  std::size_t ours_wrong{0};  ///< of the different ones
  std::vector<Truth> states;  ///< by state: the worst of all its pairs
};

/// Compares every verdict of a cycle without a budget, for which each state is the first.
/// @param geometries those of the states. Prints what is ours to mend to stderr.
SceneVerdicts compareVerdicts(const PlacedStates& states, const std::vector<Geometry>& geometries);

/// The number of states whose verdict of check_states is wrong.
std::size_t countWrong(const std::vector<StateCheck>& checks, const std::vector<Truth>& states);

}  // namespace collision_monitor::test
