// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor::fit_tool {

/// How a scene is seen: without perspective, from in front, above and one side.
///
/// Frames: in the view x points to the right, y up and z to the viewer; link frames are only
/// turned, not shifted.
struct View {
  Eigen::Matrix3d view_from_link{Eigen::Matrix3d::Identity()};
  Eigen::Vector2d center{Eigen::Vector2d::Zero()};  ///< [m] x and y at the middle of the picture
  double pixels_per_metre{1.0};
  int width{0}, height{0};  ///< pixels

  /// Column and row, fractions included, rows downwards, and z [m].
  Eigen::Vector3d pixelOf(const Eigen::Vector3d& point_in_link) const;
};

/// The view that shows all shapes and points as large as a border of 5 % allows.
View viewOf(const std::vector<PosedShape>& shapes, const std::vector<Eigen::Vector3d>& points,
            int width, int height);

/// What is seen in each pixel: the surface nearest to the viewer.
struct DepthImage {
  static constexpr int kNobody = -1;

  DepthImage(int image_width, int image_height);
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }

  int width, height;
  std::vector<double> depth;            ///< [m] z in the view, minus infinity for nothing
  std::vector<Eigen::Vector3f> normal;  ///< unit, in the view
  std::vector<int> owner;               ///< who is seen
};

/// Draws triangles, each facing the viewer whichever way it is wound.
void drawMesh(const TriangleMesh& mesh, const View& view, int owner, DepthImage& image);

/// Draws the shape itself, not triangles about it: along each pixel's ray by steps of
/// the distance to the shape.
/// Error: the surface is met within a twentieth of a pixel.
/// Source: Hart, "Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing of Implicit
/// Surfaces" (1996); departs from it in giving up as soon as the distance grows, for the distance
/// to a convex shape does not shrink again.
void drawShape(const PosedShape& shape, const View& view, int owner, DepthImage& image);

}  // namespace collision_monitor::fit_tool
