// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "support/convex_cases.h"

namespace collision_monitor::test {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

Real clampedBoxReach(const Eigen::Vector3d& half_extents, const Vector& direction) {
  return half_extents.cast<Real>().dot(direction.cwiseAbs());
}

// The greatest projection on a direction, in the body frame.
Real reach(const Sphere& s, const Vector& d) { return s.radius * d.norm(); }
Real reach(const Capsule& s, const Vector& d) {
  return s.half_length * std::abs(d.z()) + s.radius * d.norm();
}
Real reach(const Box& s, const Vector& d) { return clampedBoxReach(s.half_extents, d); }
Real reach(const RoundedBox& s, const Vector& d) {
  return clampedBoxReach(s.half_extents, d) + s.radius * d.norm();
}
Real reach(const Cylinder& s, const Vector& d) {
  return s.half_length * std::abs(d.z()) + s.radius * std::hypot(d.x(), d.y());
}
Real reach(const ConvexHull& hull, const Vector& d) {
  Real farthest = -std::numeric_limits<Real>::infinity();
  for (const Eigen::Vector3d& vertex : hull.vertices()) {
    farthest = std::max(farthest, d.dot(vertex.cast<Real>()));
  }
  return farthest;
}
Real reach(const HalfSpace&, const Vector& d) {
  const bool is_normal = std::hypot(d.x(), d.y()) < 1e-14L && d.z() > 0;
  return is_normal ? 0 : std::numeric_limits<Real>::infinity();
}

// The signed distance of a point, or a lower bound of it.
Real outside(const Sphere& s, const Vector& p) { return p.norm() - s.radius; }
Real outsideBox(const Eigen::Vector3d& half_extents, const Vector& p) {
  const Vector beyond = p.cwiseAbs() - half_extents.cast<Real>();
  return beyond.cwiseMax(Real(0)).norm() + std::min(beyond.maxCoeff(), Real(0));
}
Real outside(const Capsule& s, const Vector& p) {
  return outsideBox({0.0, 0.0, s.half_length}, p) - s.radius;
}
Real outside(const Box& s, const Vector& p) { return outsideBox(s.half_extents, p); }
Real outside(const RoundedBox& s, const Vector& p) {
  return outsideBox(s.half_extents, p) - s.radius;
}
Real outside(const Cylinder& s, const Vector& p) {
  const Vector beyond(std::hypot(p.x(), p.y()) - s.radius, 0, std::abs(p.z()) - s.half_length);
  return beyond.cwiseMax(Real(0)).norm() + std::min(std::max(beyond.x(), beyond.z()), Real(0));
}
Real outside(const ConvexHull& hull, const Vector& p) {
  if (hull.vertices().size() == 1) {
    return (p - hull.vertices()[0].cast<Real>()).norm();
  }
  Real farthest = -std::numeric_limits<Real>::infinity();
  for (const ConvexHull::Face& face : hull.faces()) {
    farthest = std::max(farthest, p.dot(face.normal.cast<Real>()) - face.offset);
  }
  return farthest;
}
Real outside(const HalfSpace&, const Vector& p) { return p.z(); }

Vector inBody(const Pose& pose, const Eigen::Vector3d& point) {
  return pose.rotation.cast<Real>().transpose() *
         (point.cast<Real>() - pose.translation.cast<Real>());
}

}  // namespace

long double extendedReach(const ConvexGeometry& geometry, const Pose& pose,
                          const Vector& direction) {
  const Vector in_body = pose.rotation.cast<Real>().transpose() * direction;
  return direction.dot(pose.translation.cast<Real>()) +
         std::visit([&](const auto& held) { return reach(held, in_body); }, geometry);
}

ConvexCertificate certify(const PosedConvexPair& pair, const SignedDistance& found) {
  const Vector normal = found.normal_a_to_b.cast<Real>().normalized();
  const auto outsideOf = [](const ConvexGeometry& geometry, const Pose& pose,
                            const Eigen::Vector3d& point) {
    const Vector in_body = inBody(pose, point);
    return static_cast<double>(
        std::visit([&](const auto& held) { return outside(held, in_body); }, geometry));
  };
  ConvexCertificate certificate;
  certificate.gap_along_normal =
      static_cast<double>(-extendedReach(*pair.b, pair.world_from_b, -normal) -
                          extendedReach(*pair.a, pair.world_from_a, normal));
  certificate.a_outside = outsideOf(*pair.a, pair.world_from_a, found.point_on_a);
  certificate.b_outside = outsideOf(*pair.b, pair.world_from_b, found.point_on_b);
  return certificate;
}

}  // namespace collision_monitor::test
