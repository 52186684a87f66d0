// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw.h"

namespace collision_monitor::fit_tool {

/// Red, green, blue, a byte each; rows from the top.
struct Picture {
  int width{0}, height{0};
  std::vector<std::uint8_t> bytes;
};

/// The colour of a shape, by its number; colours repeat.
/// Source: the palette for people who see few colours of Okabe, Ito, "Color Universal Design"
/// (2008), without black and yellow.
Eigen::Array3f colourOf(int shape);

/// The mesh as a shaded solid, the shapes as a tint over it with outlines: at the rim of each and
/// where its surface bends sharply. Two pixels of `solid` and `shapes` make one along each axis.
/// @pre both images have one size, which is even.
Picture compose(const DepthImage& solid, const DepthImage& shapes);

/// The picture of one link, 480 x 360: what it is made of and the shapes that hold it.
Picture pictureOf(const TriangleMesh& surface, const std::vector<PosedShape>& shapes);

/// PNG, by libpng.
/// @throws std::runtime_error if the library cannot
std::string encodePng(const Picture& picture);

}  // namespace collision_monitor::fit_tool
