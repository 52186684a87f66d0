// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor::fit_tool {

/// A camera without perspective, looking from the front, above and one side.
///
/// Frames: in the view, x points right, y up and z to the viewer. Link frames are only rotated, not
/// translated.
struct View {
  Eigen::Matrix3d view_from_link{Eigen::Matrix3d::Identity()};
  Eigen::Vector2d center{Eigen::Vector2d::Zero()};  ///< [m] x and y at the middle of the picture
  double pixels_per_metre{1.0};
  int width{0}, height{0};  ///< pixels

  /// Column, row (downwards) with fractions, and z [m].
  Eigen::Vector3d pixelOf(const Eigen::Vector3d& point_in_link) const;
};

/// The view that shows all shapes and points as large as a border of 5 % allows.
View viewOf(const std::vector<PosedShape>& shapes, const std::vector<Eigen::Vector3d>& points,
            int width, int height);

/// The visible surface in each pixel: the one nearest to the viewer.
struct DepthImage {
  static constexpr int kNobody = -1;

  DepthImage(int image_width, int image_height);
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }

  int width, height;
  std::vector<double> depth;            ///< [m] z in the view, minus infinity if there is none
  std::vector<Eigen::Vector3f> normal;  ///< unit, in the view
  std::vector<int> owner;               ///< number of the visible object
};

/// Draws triangles on both sides, whatever their winding.
void drawMesh(const TriangleMesh& mesh, const View& view, int owner, DepthImage& image);

/// Draws the shape itself, without triangles: follows each pixel's ray in steps of the distance to
/// the shape.
/// Error: the surface is hit within a twentieth of a pixel.
/// Source: Hart, "Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing of Implicit
/// Surfaces" (1996). Departure: gives up as soon as the distance grows, because the distance to a
/// convex shape then never shrinks again.
void drawShape(const PosedShape& shape, const View& view, int owner, DepthImage& image);

}  // namespace collision_monitor::fit_tool
