// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_monitor/broad_phase/body_bounds.h"
#include "support/random_poses.h"

namespace collision_monitor::bench {

enum class SceneKind : unsigned char {
  coherent,   ///< evenly spread; each moves by a hundredth of the mean edge per frame
  random,     ///< evenly spread; each is anywhere else in the next frame
  clustered,  ///< half as coherent, half in crowds of about a hundred
  beams       ///< 0.2 m thick and 30 m long along any of the axes; motion as coherent
};

const char* nameOf(SceneKind kind) noexcept;

/// Boxes of 1 m mean edge. Each meets 2.6 others on average (1.3 pairs per body).
class BoxScene {
 public:
  BoxScene(SceneKind kind, std::size_t count);

  const BodyBounds& bounds() const noexcept { return bounds_; }
  double side() const noexcept { return side_; }  ///< [m] of the cube that holds all centers
  void advance();

 private:
  void place(std::size_t body);

  SceneKind kind_;
  double side_;
  test::Random random_;
  BodyBounds bounds_;
  std::vector<Eigen::Vector3d> half_edges_;
  std::vector<Eigen::Vector3d> velocities_;  ///< [m] per frame
};

}  // namespace collision_monitor::bench
