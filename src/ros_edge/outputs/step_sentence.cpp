// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/object_links.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {

std::string stepSentence(const Watch& watch) {
  const CycleSetup& setup = watch.setup();
  const StepLimit& step = watch.buffers.sweep.step;
  const bool is_covered = !step.on_way.is_exceeded;
  const StepCap& cap = is_covered ? step.at_poses : step.on_way;
  if (!cap.is_exceeded) {
    return "";
  }
  const CheckedLinkPair& pair = setup.checked[cap.pair];
  const std::string links =
      nameInText(setup.model, pair.a) + " and " + nameInText(setup.model, pair.b);
  const std::string every = "every " + fixedText(1e3 * step.step, 1) + " ms";
  const std::string needed = "every " + fixedText(1e3 * cap.longest, 1) + " ms";
  if (is_covered) {
    return links +
           " move so fast that they could pass through each other from one pose to the next (" +
           every + "); the monitor also looks at the way in between, so nothing is missed " +
           "(without that, poses would be needed " + needed + ")";
  }
  const char* const danger =
      setup.is_continuous ? " speed up or slow down so much that they may pass through each other "
                            "unseen, though the monitor looks at the way in between"
                          : " can pass through each other unseen (parameter continuous is off)";
  return "poses " + every + " are too few: from one to the next, " + links + danger +
         "; at these speeds poses are needed " + needed;
}

}  // namespace collision_monitor
