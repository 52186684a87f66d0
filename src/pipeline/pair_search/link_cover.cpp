// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/link_cover.h"

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// Corners of a box about the origin; fewer where half extents are 0.
std::vector<Eigen::Vector3d> cornersOf(const Eigen::Vector3d& half_extents) {
  std::vector<Eigen::Vector3d> corners{Eigen::Vector3d::Zero()};
  for (int axis = 0; axis < 3; ++axis) {
    if (half_extents[axis] > 0.0) {
      const std::size_t count = corners.size();
      for (std::size_t i = 0; i < count; ++i) {
        corners.push_back(corners[i]);
        corners[i][axis] -= half_extents[axis];
        corners.back()[axis] += half_extents[axis];
      }
    }
  }
  return corners;
}

/// Points whose hull holds the cylinder: prisms about both its ends.
std::vector<Eigen::Vector3d> prismAbout(const Cylinder& cylinder) {
  constexpr int kSides = 16;
  const double radius = cylinder.radius / std::cos(kPi / kSides) * (1.0 + 1e-12);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * kPi * i / kSides;
    for (const double side : {-1.0, 1.0}) {
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                          side * cylinder.half_length);
    }
  }
  return points;
}

/// Takes the farthest point again and again, until all are within `radius` of those taken.
/// Source: Gonzalez, "Clustering to minimize the maximum intercluster distance" (1985).
PointCover fewPoints(const std::vector<Eigen::Vector3d>& points) {
  constexpr std::size_t kMost = 128;
  if (points.size() <= kMost) {
    return {points, 0.0};
  }
  PointCover cover;
  std::vector<double> away(points.size(), kInfinity);
  std::size_t farthest = 0;
  while (cover.points.size() < kMost) {
    cover.points.push_back(points[farthest]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      away[i] = std::min(away[i], (points[i] - cover.points.back()).norm());
    }
    farthest = static_cast<std::size_t>(std::max_element(away.begin(), away.end()) - away.begin());
  }
  cover.radius = away[farthest] * (1.0 + 1e-12);
  return cover;
}

struct CoverOf {
  PointCover operator()(const Sphere& sphere) const {
    return {{Eigen::Vector3d::Zero()}, sphere.radius};
  }
  PointCover operator()(const Capsule& capsule) const {
    return {cornersOf({0.0, 0.0, capsule.half_length}), capsule.radius};
  }
  PointCover operator()(const Box& box) const { return {cornersOf(box.half_extents), 0.0}; }
  PointCover operator()(const RoundedBox& box) const {
    return {cornersOf(box.half_extents), box.radius};
  }
  PointCover operator()(const Cylinder& cylinder) const { return {prismAbout(cylinder), 0.0}; }
  PointCover operator()(const ConvexHull& hull) const { return fewPoints(hull.vertices()); }
  PointCover operator()(const HalfSpace& /*unbounded*/) const { return {{}, kInfinity}; }
};

PointCover hullCover(const Element& element) {
  const std::optional<ConvexGeometry>& geometry = element.convex ? element.convex : element.hull;
  PointCover cover = geometry ? std::visit(CoverOf{}, *geometry) : PointCover{{}, kInfinity};
  cover.radius += element.padding;
  for (Eigen::Vector3d& point : cover.points) {
    point = element.link_from_element * point;
  }
  return cover;
}

/// Cuts the core of a body into boxes, at most `most`, and adds the ball of each.
void addBalls(const Body& body, std::size_t most, std::vector<Ball>& balls) {
  Eigen::Vector3d half = coreHalfExtents(body.shape);
  Eigen::Array3i counts = Eigen::Array3i::Ones();
  const double radius = radiusOf(body.shape);
  int longest = 0;
  while (2 * static_cast<std::size_t>(counts.prod()) <= most &&
         half.maxCoeff(&longest) > 0.25 * radius) {
    counts[longest] *= 2;
    half[longest] *= 0.5;
  }
  const Eigen::Vector3d all = coreHalfExtents(body.shape);
  for (int x = 0; x < counts.x(); ++x) {
    for (int y = 0; y < counts.y(); ++y) {
      for (int z = 0; z < counts.z(); ++z) {
        const Eigen::Vector3d place = Eigen::Vector3d(2.0 * x + 1.0, 2.0 * y + 1.0, 2.0 * z + 1.0);
        balls.push_back({body.link_from_body * (half.cwiseProduct(place) - all).eval(),
                         (half.norm() + radius) * (1.0 + 1e-12)});
      }
    }
  }
}

Ball transformed(const Pose& a_from_b, const Ball& ball) {
  return {a_from_b * ball.center, ball.radius};
}

std::vector<InnerConvex> innerOf(const Element& element) {
  std::vector<InnerConvex> inner;
  if (!element.is_exact) {
    return inner;
  }
  const auto add = [&](const ConvexGeometry& geometry, const Pose& element_from_geometry) {
    const Pose pose = element.link_from_element * element_from_geometry;
    inner.push_back({geometry, pose, transformed(pose, ballOf(geometry))});
  };
  if (element.convex) {
    add(*element.convex, Pose());
    return inner;
  }
  for (const auto& shape : {element.inner.capsule, element.inner.sphere}) {
    if (shape) {
      std::visit([&](const auto& kind) { add(kind, shape->geometry_from_body); }, shape->shape);
    }
  }
  return inner;
}

/// A ball about the box of all balls.
Ball ballAbout(const std::vector<Ball>& balls) {
  Eigen::Vector3d least = Eigen::Vector3d::Constant(kInfinity);
  Eigen::Vector3d most = -least;
  for (const Ball& ball : balls) {
    least = least.cwiseMin((ball.center.array() - ball.radius).matrix());
    most = most.cwiseMax((ball.center.array() + ball.radius).matrix());
  }
  Ball about{0.5 * (least + most), 0.0};
  for (const Ball& ball : balls) {
    about.radius = std::max(about.radius, (ball.center - about.center).norm() + ball.radius);
  }
  return about;
}

}  // namespace

std::vector<ElementCover> coverElements(const CycleSetup& setup) {
  constexpr std::size_t kMostBalls = 16;
  std::vector<ElementCover> covers(setup.elements.size());
  std::vector<std::size_t> bodies(setup.elements.size(), 0);
  for (const Body& body : setup.bodies) {
    ++bodies[index(body.element)];
  }
  for (const Body& body : setup.bodies) {
    const std::size_t most = std::max<std::size_t>(1, kMostBalls / bodies[index(body.element)]);
    addBalls(body, most, covers[index(body.element)].balls);
  }
  for (std::size_t i = 0; i < covers.size(); ++i) {
    covers[i].ball = ballAbout(covers[i].balls);
    covers[i].hull = hullCover(setup.elements[i]);
    covers[i].inner = innerOf(setup.elements[i]);
  }
  return covers;
}

}  // namespace collision_monitor
