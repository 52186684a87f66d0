// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/lanes/lane_targets.h"
// Must come first.
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace collision_monitor::test {

/// The instruction sets that batched kernels were compiled for and that this machine has, best
/// first. hwy::TargetName names them.
inline std::vector<std::int64_t> instructionSets() { return hwy::SupportedAndGeneratedTargets(); }

/// While it lives, batched kernels use only one instruction set.
class OnlyInstructionSet {
 public:
  explicit OnlyInstructionSet(std::int64_t target) { choose(target); }
  ~OnlyInstructionSet() { choose(0); }
  OnlyInstructionSet(const OnlyInstructionSet&) = delete;
  OnlyInstructionSet& operator=(const OnlyInstructionSet&) = delete;

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace collision_monitor::test
