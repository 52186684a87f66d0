// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/pipeline/setup.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {

/// An arm of two links in the plane: balls of 0.1 m at the shoulder (base, at the origin), and 1 m
/// out from the elbow (hand), which is 1 m from the shoulder; and a post, a ball of 0.1 m at (1,
/// 1). Pairs: base and hand (not adjacent), hand and post; the upper arm has no geometry.
inline CycleSetup armSetup() {
  const std::string ball = "<sphere radius='0.1'/>";
  const std::string about_z =
      "<axis xyz='0 0 1'/><limit lower='-4' upper='4' velocity='1' effort='1'/>";
  const std::string xml =
      linkXml("base", ball) + linkXml("upper", "<sphere radius='0.05'/>") +
      linkXml("hand", ball, "<origin xyz='1 0 0'/>") + linkXml("post", ball) +
      jointXml("shoulder", "revolute", "base", "upper", about_z) +
      jointXml("elbow", "revolute", "upper", "hand", "<origin xyz='1 0 0'/>" + about_z) +
      jointXml("stand", "fixed", "base", "post", "<origin xyz='1 1 0'/>");
  return buildSetup({describeText(robotXml(xml))}, textLoader({}), SetupOptions());
}

}  // namespace collision_monitor::test
