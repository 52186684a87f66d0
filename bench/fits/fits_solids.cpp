// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fits_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

/// A curve from the pole to the equator, to be revolved around z.
struct Profile {
  std::vector<Eigen::Vector2d> points;  ///< distance from the axis, height
  std::vector<double> lengths;          ///< length of the curve that each point represents
};

void addPiece(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double spacing,
              Profile& profile) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / spacing)));
  for (int i = 0; i <= steps; ++i) {
    const double weight = i == 0 || i == steps ? 0.5 : 1.0;
    profile.points.emplace_back(from + (to - from) * (static_cast<double>(i) / steps));
    profile.lengths.push_back(weight * (to - from).norm() / steps);
  }
}

Profile profileOf(const Solid& solid, double spacing) {
  const double top = solid.half_extents.z() + solid.radius;
  Profile profile;
  addPiece({0.0, top}, {solid.rim, top}, spacing, profile);
  const int steps = std::max(1, static_cast<int>(std::ceil(0.5 * kPi * solid.radius / spacing)));
  for (int i = 0; i < steps && solid.radius > 0.0; ++i) {
    const auto at = [&](int step) {
      const double angle = 0.5 * kPi * step / steps;
      return Eigen::Vector2d(solid.rim + solid.radius * std::sin(angle),
                             solid.half_extents.z() + solid.radius * std::cos(angle));
    };
    addPiece(at(i), at(i + 1), spacing, profile);
  }
  const double side = solid.rim + solid.radius;
  addPiece({side, solid.half_extents.z()}, {side, 0.0}, spacing, profile);
  return profile;
}

std::vector<SurfaceSample> samplesOfCylinder(const Solid& solid, int count) {
  const double side = solid.rim + solid.radius;
  const double area = 2.0 * kPi * side * (side + 2.0 * (solid.half_extents.z() + solid.radius));
  const double spacing = std::sqrt(area / count);
  const Profile profile = profileOf(solid, spacing);
  std::vector<SurfaceSample> samples;
  for (std::size_t i = 0; i < profile.points.size(); ++i) {
    const double round = 2.0 * kPi * profile.points[i].x();
    const int steps = std::max(1, static_cast<int>(std::ceil(round / spacing)));
    for (int k = 0; k < steps; ++k) {
      const double angle = 2.0 * kPi * k / steps;
      for (const double above : {1.0, -1.0}) {
        samples.push_back({{profile.points[i].x() * std::cos(angle),
                            profile.points[i].x() * std::sin(angle), above * profile.points[i].y()},
                           round / steps * profile.lengths[i]});
      }
    }
  }
  return samples;
}

struct ToSolid {
  Solid operator()(const Sphere& sphere) const {
    return {{}, Vector3d::Zero(), 0.0, sphere.radius};
  }
  Solid operator()(const Capsule& capsule) const {
    return {{}, {0.0, 0.0, capsule.half_length}, 0.0, capsule.radius};
  }
  Solid operator()(const Box& box) const { return {{}, box.half_extents, 0.0, 0.0}; }
  Solid operator()(const Cylinder& cylinder) const {
    return {{}, {0.0, 0.0, cylinder.half_length}, cylinder.radius, 0.0};
  }
  Solid operator()(const TriangleMesh&) const {
    throw std::invalid_argument("a mesh among the shapes of a model; primitives are accepted");
  }
};

}  // namespace

Solid toSolid(const Geometry& geometry, const Pose& link_from_body) {
  Solid solid = std::visit(ToSolid(), geometry);
  solid.link_from_body = link_from_body;
  return solid;
}

std::vector<Solid> toSolids(const Link& link, const std::vector<Fit>& fits) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    for (const auto& enclosure : fits[i].shapes) {
      solids.push_back({link.collisions[i].link_from_geometry * enclosure.geometry_from_body,
                        coreHalfExtents(enclosure.shape), 0.0, radiusOf(enclosure.shape)});
    }
  }
  return solids;
}

double signedDistance(const Solid& solid, const Vector3d& point) noexcept {
  const Vector3d at =
      solid.link_from_body.rotation.transpose() * (point - solid.link_from_body.translation);
  Vector3d beyond = at.cwiseAbs() - solid.half_extents;
  if (solid.rim > 0.0) {
    beyond.x() = std::hypot(at.x(), at.y()) - solid.rim;
    beyond.y() = -std::numeric_limits<double>::infinity();
  }
  const double outside = beyond.cwiseMax(0.0).norm();
  return (outside > 0.0 ? outside : beyond.maxCoeff()) - solid.radius;
}

std::vector<SurfaceSample> samplesOf(const Solid& solid, int count) {
  auto samples = solid.rim > 0.0
                     ? samplesOfCylinder(solid, count)
                     : sampleSurface(RoundedBox{solid.half_extents, solid.radius}, count);
  for (auto& sample : samples) {
    sample.point = solid.link_from_body * sample.point;
  }
  return samples;
}

TriangleMesh meshOf(const Link& link) {
  TriangleMesh all;
  for (const auto& element : link.collisions) {
    if (const auto* mesh = std::get_if<TriangleMesh>(&element.geometry)) {
      const auto first = static_cast<std::uint32_t>(all.vertices.size());
      for (const auto& vertex : mesh->vertices) {
        all.vertices.push_back(element.link_from_geometry * vertex);
      }
      for (const auto& t : mesh->triangles) {
        all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      }
    }
  }
  return all;
}

Points densePoints(const TriangleMesh& mesh) {
  constexpr int kSteps = 100;
  Points points = mesh.vertices;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  for (const auto& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const double spacing = (high - low).norm() / kSteps;
  for (const auto& t : mesh.triangles) {
    const Vector3d& a = mesh.vertices[t[0]];
    const Vector3d u = mesh.vertices[t[1]] - a;
    const Vector3d v = mesh.vertices[t[2]] - a;
    const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
    const int steps = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 2, kSteps);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        points.emplace_back(a + u * (static_cast<double>(i) / steps) +
                            v * (static_cast<double>(j) / steps));
      }
    }
  }
  return points;
}

double missOf(const std::vector<Solid>& solids, const Points& points) noexcept {
  double worst = 0.0;
  for (const auto& point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < solids.size() && nearest > worst; ++i) {
      nearest = std::min(nearest, signedDistance(solids[i], point));
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace collision_monitor::test
