// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace collision_monitor::fit_tool {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 360;
constexpr int kOversampling = 2;

/// Light comes from above, on the viewer's left.
float brightnessOf(const Eigen::Vector3f& normal) {
  const Eigen::Vector3f to_light = Eigen::Vector3f(-0.45F, 0.65F, 0.6F).normalized();
  return 0.5F + 0.47F * std::max(normal.dot(to_light), 0.0F);
}

/// Whether an outline runs between two pixels: between two shapes, at a rim or at a sharp bend.
bool isOutlined(const DepthImage& shapes, std::size_t here, std::size_t there) {
  constexpr float kBend = 0.87F;  // cosine of 30 degrees
  return shapes.owner[here] != shapes.owner[there] ||
         (shapes.owner[here] != DepthImage::kNobody &&
          shapes.normal[here].dot(shapes.normal[there]) < kBend);
}

/// The line is drawn in the shape nearer to the viewer. It is two pixels wide before the image is
/// halved.
bool drawsOutline(const DepthImage& shapes, int column, int row) {
  constexpr std::array<std::array<int, 2>, 4> kNeighbours{{{-2, 0}, {2, 0}, {0, -2}, {0, 2}}};
  const std::size_t here = shapes.at(column, row);
  return std::any_of(kNeighbours.begin(), kNeighbours.end(), [&](const auto& step) {
    const int x = column + step[0];
    const int y = row + step[1];
    if (x < 0 || y < 0 || x >= shapes.width || y >= shapes.height) {
      return false;
    }
    const std::size_t there = shapes.at(x, y);
    return shapes.depth[there] <= shapes.depth[here] && isOutlined(shapes, here, there);
  });
}

Eigen::Array3f colourOfPixel(const DepthImage& solid, const DepthImage& shapes, int column,
                             int row) {
  const std::size_t pixel = solid.at(column, row);
  const bool is_solid = solid.owner[pixel] != DepthImage::kNobody;
  Eigen::Array3f colour = Eigen::Array3f::Ones();
  if (is_solid) {
    colour = brightnessOf(solid.normal[pixel]) * Eigen::Array3f(0.93F, 0.95F, 1.0F);
  }
  if (shapes.owner[pixel] == DepthImage::kNobody) {
    return colour;
  }
  const Eigen::Array3f tint = colourOf(shapes.owner[pixel]);
  if (drawsOutline(shapes, column, row)) {
    return 0.1F * colour + 0.9F * tint;
  }
  const float part = is_solid ? 0.25F : 0.3F;
  const float shade = 0.55F + 0.5F * brightnessOf(shapes.normal[pixel]);
  return (1.0F - part) * colour + part * (shade * tint).min(1.0F);
}

}  // namespace

Eigen::Array3f colourOf(int shape) {
  static const std::array<Eigen::Array3f, 6> kColours{
      Eigen::Array3f(0.00F, 0.45F, 0.70F), Eigen::Array3f(0.84F, 0.37F, 0.00F),
      Eigen::Array3f(0.00F, 0.62F, 0.45F), Eigen::Array3f(0.80F, 0.47F, 0.65F),
      Eigen::Array3f(0.90F, 0.62F, 0.00F), Eigen::Array3f(0.34F, 0.71F, 0.91F)};
  return kColours[static_cast<std::size_t>(shape) % kColours.size()];
}

Picture compose(const DepthImage& solid, const DepthImage& shapes) {
  Picture picture{solid.width / kOversampling, solid.height / kOversampling, {}};
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      Eigen::Array3f sum = Eigen::Array3f::Zero();
      for (int i = 0; i < kOversampling * kOversampling; ++i) {
        sum += colourOfPixel(solid, shapes, kOversampling * column + i % kOversampling,
                             kOversampling * row + i / kOversampling);
      }
      const Eigen::Array3f mean = sum / (kOversampling * kOversampling);
      for (Eigen::Index i = 0; i < 3; ++i) {
        picture.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0F * mean[i])));
      }
    }
  }
  return picture;
}

Picture pictureOf(const TriangleMesh& surface, const std::vector<PosedShape>& shapes) {
  const View view =
      viewOf(shapes, surface.vertices, kOversampling * kWidth, kOversampling * kHeight);
  DepthImage solid(view.width, view.height);
  drawMesh(surface, view, 0, solid);
  DepthImage outside(view.width, view.height);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    drawShape(shapes[i], view, static_cast<int>(i), outside);
  }
  return compose(solid, outside);
}

}  // namespace collision_monitor::fit_tool
