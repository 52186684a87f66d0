// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/vertex_blocks.h"

#include <gtest/gtest.h>

#include <random>

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

std::uint32_t farthestOfAll(const std::vector<Vector3d>& vertices, const Vector3d& direction) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < vertices.size(); ++i) {
    best = direction.dot(vertices[i]) > direction.dot(vertices[best]) ? i : best;
  }
  return best;
}

void expectAsOfAll(const std::vector<Vector3d>& vertices, const std::vector<Vector3d>& directions) {
  const VertexBlocks blocks(vertices);
  std::uint32_t likely = 0;
  for (const Vector3d& direction : directions) {
    const std::uint32_t expected = farthestOfAll(vertices, direction);
    EXPECT_EQ(blocks.farthest(direction, likely), expected) << direction.transpose();
    likely = (7 * likely + 3) % static_cast<std::uint32_t>(vertices.size());
  }
}

class Draw {
 public:
  Vector3d point(double size) { return {size * next(), size * next(), size * next()}; }
  std::vector<Vector3d> points(int count, double size) {
    std::vector<Vector3d> all;
    for (int i = 0; i < count; ++i) {
      all.push_back(point(size));
    }
    return all;
  }

 private:
  double next() { return std::uniform_real_distribution<>(-1.0, 1.0)(random_); }

  std::mt19937 random_{5};
};

TEST(VertexBlocks, farthestIsThatOfALookAtAll) {
  Draw draw;
  for (const int count : {1, 2, 16, 17, 33, 1000}) {
    for (const double size : {1e-9, 1.0, 1e6}) {
      std::vector<Vector3d> on_ball = draw.points(count, 1.0);
      for (Vector3d& vertex : on_ball) {
        vertex = size * vertex.normalized();
      }
      expectAsOfAll(on_ball, draw.points(50, 2.0));
      expectAsOfAll(draw.points(count, size), draw.points(50, 1e-3));
    }
  }
}

/// Of faces of a box all corners reach as far, to rounding; away from the origin that is coarse.
TEST(VertexBlocks, ofSeveralTheFirstIsTaken) {
  const std::vector<Vector3d> axes = {Vector3d::UnitX(), -Vector3d::UnitY(), {0.6, 0.8, 0.0},
                                      {1.0, 1.0, 1.0},   {0.0, 0.0, 0.0},    {1e-3, 0.3, -0.7}};
  for (const Vector3d& offset : {Vector3d(0, 0, 0), Vector3d(1e5, -3e5, 2e5)}) {
    std::vector<Vector3d> grid;
    for (int i = 0; i < 1000; ++i) {
      grid.push_back(offset + 0.1 * Vector3d(i % 10, i / 10 % 10, i / 100));
    }
    grid.insert(grid.end(), grid.begin(), grid.begin() + 500);
    expectAsOfAll(grid, axes);
  }
}

}  // namespace
}  // namespace collision_monitor::test
