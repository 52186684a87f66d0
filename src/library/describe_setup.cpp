// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "library/monitor_parts.h"

namespace collision_monitor {
namespace {

const char* endingOf(const Joint& joint, std::size_t variable) {
  constexpr const char* kPlanar[] = {"/x", "/y", "/theta"};
  constexpr const char* kFloating[] = {"/trans_x", "/trans_y", "/trans_z", "/rot_x",
                                       "/rot_y",   "/rot_z",   "/rot_w"};
  return joint.type == JointType::planar     ? kPlanar[variable]
         : joint.type == JointType::floating ? kFloating[variable]
                                             : "";
}

std::size_t variablesOf(const Joint& joint) noexcept {
  constexpr std::size_t kFloating = 7;
  return joint.mimic ? 0 : joint.type == JointType::floating ? kFloating : freedomOf(joint);
}

std::vector<JointVariable> listVariables(const RobotModel& model) {
  std::vector<JointVariable> variables(model.variable_count);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    for (std::size_t k = 0; k < variablesOf(joint); ++k) {
      variables[joint.first_variable + k] = {joint.name + endingOf(joint, k), idAt<JointId>(i),
                                             joint.lower, joint.upper, joint.max_velocity};
    }
  }
  return variables;
}

std::vector<EnclosingShape> listShapes(const CycleSetup& setup) {
  std::vector<EnclosingShape> shapes;
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const Body& body = setup.bodies[i];
    const BodyLabel& label = setup.labels[i];
    shapes.push_back({body.link, label.shape_name, body.shape, body.link_from_body, label.overshoot,
                      body.is_exact, label.is_proven});
  }
  return shapes;
}

}  // namespace

void describeSetup(MonitorParts& parts) {
  const RobotModel& model = parts.setup.model;
  parts.world_from_root = parts.options.world_from_root;
  parts.world_from_root.resize(model.robots.size());
  parts.variables = listVariables(model);
  parts.default_state = defaultPositions(model);
  parts.shapes = listShapes(parts.setup);
}

}  // namespace collision_monitor
