// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// For each vertex the first one that equals it.
std::vector<std::uint32_t> firstEquals(const std::vector<Eigen::Vector3d>& vertices);

}  // namespace collision_monitor
