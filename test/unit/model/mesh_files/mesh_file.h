// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "model/mesh_files/mesh_reader.h"

namespace collision_monitor::test {

/// Of the error that reading ends in.
inline std::string messageOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no exception";
}

/// (0,0,0) (1,0,0) (0,2,0), as in every file of these tests.
inline void expectTheTriangle(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(0.0, 0.0, 0.0));
  EXPECT_EQ(mesh.vertices[1], Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(0.0, 2.0, 0.0));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

}  // namespace collision_monitor::test
