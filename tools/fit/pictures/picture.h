// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw.h"

namespace collision_monitor::fit_tool {

/// Red, green and blue, one byte each; rows from the top.
struct Picture {
  int width{0}, height{0};
  std::vector<std::uint8_t> bytes;
};

/// The color of shape number `shape`; colors repeat.
/// Source: the color-blind-safe palette of Okabe, Ito, "Color Universal Design" (2008), without
/// black and yellow.
Eigen::Array3f colourOf(int shape);

/// The mesh as a shaded solid, with the shapes as tints and outlines over it. Outlines are at rims
/// and sharp bends. Two by two pixels of `solid` and `shapes` become one.
/// @pre both images have the same size, which is even.
Picture compose(const DepthImage& solid, const DepthImage& shapes);

/// A picture of one link, 480 x 360: its geometry and its enclosing shapes.
Picture pictureOf(const TriangleMesh& surface, const std::vector<PosedShape>& shapes);

/// PNG, by libpng.
/// @throws std::runtime_error if the library cannot
std::string encodePng(const Picture& picture);

}  // namespace collision_monitor::fit_tool
