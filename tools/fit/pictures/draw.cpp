// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "draw.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor::fit_tool {
namespace {

/// The pixels that may be touched: the smallest rectangle of whole pixels, inside the image.
struct PixelRange {
  int first_column, last_column, first_row, last_row;
};

PixelRange rangeOf(const Eigen::Vector2d& least, const Eigen::Vector2d& most,
                   const DepthImage& image) {
  const auto within = [](double value, int end) {
    return static_cast<int>(std::clamp(std::floor(value), -1.0, static_cast<double>(end)));
  };
  return {std::max(within(least.x(), image.width), 0),
          std::min(within(most.x(), image.width), image.width - 1),
          std::max(within(least.y(), image.height), 0),
          std::min(within(most.y(), image.height), image.height - 1)};
}

double crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

void draw(std::size_t pixel, double depth, const Eigen::Vector3d& normal, int owner,
          DepthImage& image) {
  if (depth > image.depth[pixel]) {
    image.depth[pixel] = depth;
    image.normal[pixel] = normal.cast<float>();
    image.owner[pixel] = owner;
  }
}

void drawTriangle(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& normal,
                  int owner, DepthImage& image) {
  const Eigen::Vector2d a = corners[0].head<2>();
  const Eigen::Vector2d b = corners[1].head<2>();
  const Eigen::Vector2d c = corners[2].head<2>();
  const double area = crossOf(b - a, c - a);
  if (area == 0.0) {
    return;
  }
  const PixelRange range = rangeOf(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), image);
  for (int row = range.first_row; row <= range.last_row; ++row) {
    for (int column = range.first_column; column <= range.last_column; ++column) {
      const Eigen::Vector2d middle(column + 0.5, row + 0.5);
      const double weight_a = crossOf(c - b, middle - b) / area;
      const double weight_b = crossOf(a - c, middle - c) / area;
      const double weight_c = 1.0 - weight_a - weight_b;
      if (weight_a >= 0.0 && weight_b >= 0.0 && weight_c >= 0.0) {
        const double depth =
            weight_a * corners[0].z() + weight_b * corners[1].z() + weight_c * corners[2].z();
        draw(image.at(column, row), depth, normal, owner, image);
      }
    }
  }
}

/// A ray in the body frame; `direction` is unit.
struct Ray {
  Eigen::Vector3d start;
  Eigen::Vector3d direction;
};

/// Distance along the ray to the shape; infinity if it misses.
double traceRay(const Shape& shape, const Ray& ray, double tolerance) {
  constexpr int kMostSteps = 200;
  double travelled = 0.0;
  double before = kInfinity;
  for (int i = 0; i < kMostSteps; ++i) {
    const double distance = signedDistanceTo(shape, ray.start + travelled * ray.direction);
    if (distance <= tolerance) {
      return travelled;
    }
    if (distance > before) {
      return kInfinity;
    }
    before = distance;
    travelled += distance;
  }
  return kInfinity;
}

/// Direction from the nearest point of the core.
Eigen::Vector3d normalAt(const Shape& shape, const Eigen::Vector3d& point,
                         const Eigen::Vector3d& fallback) {
  const Eigen::Vector3d core = coreHalfExtents(shape);
  const Eigen::Vector3d from_core = point - point.cwiseMax(-core).cwiseMin(core);
  const double length = from_core.norm();
  return length > 0.0 ? Eigen::Vector3d(from_core / length) : fallback;
}

/// Half extents of the shape along the view's axes, with its center at the origin.
Eigen::Vector3d reachOf(const Shape& shape, const Eigen::Matrix3d& view_from_body) {
  Eigen::Vector3d reach;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = view_from_body.row(axis).transpose();
    reach[axis] = direction.dot(supportPoint(shape, direction));
  }
  return reach;
}

}  // namespace

DepthImage::DepthImage(int image_width, int image_height)
    : width(image_width), height(image_height) {
  const std::size_t count = at(0, height);
  depth.assign(count, -kInfinity);
  normal.assign(count, Eigen::Vector3f::Zero());
  owner.assign(count, kNobody);
}

Eigen::Vector3d View::pixelOf(const Eigen::Vector3d& point_in_link) const {
  const Eigen::Vector3d point = view_from_link * point_in_link;
  return {0.5 * width + (point.x() - center.x()) * pixels_per_metre,
          0.5 * height - (point.y() - center.y()) * pixels_per_metre, point.z()};
}

View viewOf(const std::vector<PosedShape>& shapes, const std::vector<Eigen::Vector3d>& points,
            int width, int height) {
  constexpr double kFilled = 0.9;
  const Eigen::Vector3d to_viewer = Eigen::Vector3d(1.0, -0.75, 0.65).normalized();
  View view;
  view.width = width;
  view.height = height;
  view.view_from_link.row(0) = Eigen::Vector3d::UnitZ().cross(to_viewer).normalized();
  view.view_from_link.row(2) = to_viewer;
  view.view_from_link.row(1) = to_viewer.cross(view.view_from_link.row(0));
  Eigen::Vector2d least = Eigen::Vector2d::Constant(kInfinity);
  Eigen::Vector2d most = -least;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector2d seen = (view.view_from_link * point).head<2>();
    least = least.cwiseMin(seen);
    most = most.cwiseMax(seen);
  }
  for (const PosedShape& shape : shapes) {
    const Pose& link_from_body = shape.geometry_from_body;
    const Eigen::Vector2d reach =
        reachOf(shape.shape, view.view_from_link * link_from_body.rotation).head<2>();
    const Eigen::Vector2d seen = (view.view_from_link * link_from_body.translation).head<2>();
    least = least.cwiseMin(seen - reach);
    most = most.cwiseMax(seen + reach);
  }
  if (shapes.empty() && points.empty()) {
    return view;
  }
  const Eigen::Vector2d size = (most - least).cwiseMax(1e-9);
  view.center = 0.5 * (least + most);
  view.pixels_per_metre = kFilled * std::min(width / size.x(), height / size.y());
  return view;
}

void drawMesh(const TriangleMesh& mesh, const View& view, int owner, DepthImage& image) {
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    corners.push_back(view.pixelOf(vertex));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    Eigen::Vector3d normal = view.view_from_link * (mesh.vertices[b] - mesh.vertices[a])
                                                       .cross(mesh.vertices[c] - mesh.vertices[a])
                                                       .normalized();
    normal *= normal.z() < 0.0 ? -1.0 : 1.0;
    drawTriangle({corners[a], corners[b], corners[c]}, normal, owner, image);
  }
}

void drawShape(const PosedShape& shape, const View& view, int owner, DepthImage& image) {
  const Pose& link_from_body = shape.geometry_from_body;
  const Eigen::Matrix3d view_from_body = view.view_from_link * link_from_body.rotation;
  const Eigen::Vector3d reach = reachOf(shape.shape, view_from_body);
  const Eigen::Vector3d middle = view.pixelOf(link_from_body.translation);
  const Eigen::Vector2d half = view.pixels_per_metre * reach.head<2>();
  const PixelRange range = rangeOf(middle.head<2>() - half, middle.head<2>() + half, image);
  const double tolerance = 0.05 / view.pixels_per_metre;
  Ray ray;
  ray.direction = -view_from_body.row(2).transpose();
  for (int row = range.first_row; row <= range.last_row; ++row) {
    for (int column = range.first_column; column <= range.last_column; ++column) {
      const Eigen::Vector3d start((column + 0.5 - middle.x()) / view.pixels_per_metre,
                                  -(row + 0.5 - middle.y()) / view.pixels_per_metre, reach.z());
      ray.start = view_from_body.transpose() * start;
      const double travelled = traceRay(shape.shape, ray, tolerance);
      if (travelled < kInfinity) {
        const Eigen::Vector3d normal =
            normalAt(shape.shape, ray.start + travelled * ray.direction, -ray.direction);
        draw(image.at(column, row), middle.z() + reach.z() - travelled, view_from_body * normal,
             owner, image);
      }
    }
  }
}

}  // namespace collision_monitor::fit_tool
