// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>

#include "collision_monitor/fitting/posed_shape.h"
#include "model/place.h"

namespace collision_monitor {

/// One shape of a rules file: `{kind: capsule, radius: 0.05, length: 0.3, xyz: [0, 0, 0.1]}`.
/// Adds each fault to the place and then returns nothing.
std::optional<PosedShape> readGivenShape(const YAML::Node& node, const Place& place);

/// The same shape as text on one line, with nine digits.
std::string toYaml(const PosedShape& shape);

}  // namespace collision_monitor
