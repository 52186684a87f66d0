// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// A kind of joint and its name in a URDF.
struct JointTypeName {
  const char* name;
  JointType type;
};

constexpr JointTypeName kJointTypeNames[] = {
    {"fixed", JointType::fixed},           {"revolute", JointType::revolute},
    {"continuous", JointType::continuous}, {"prismatic", JointType::prismatic},
    {"planar", JointType::planar},         {"floating", JointType::floating}};

inline const char* nameOf(JointType type) {
  for (const JointTypeName& known : kJointTypeNames) {
    if (known.type == type) {
      return known.name;
    }
  }
  return "";
}

}  // namespace collision_monitor
