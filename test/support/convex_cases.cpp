// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/convex_cases.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace collision_monitor::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

int anyOf(int count, Random& random) {
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

double anyLength(const ConvexPoolRecipe& recipe, Random& random) {
  if (recipe.with_degenerate && anyOf(6, random) == 0) {
    return 0.0;
  }
  return std::exp(uniform(random, std::log(recipe.least_length), std::log(recipe.greatest_length)));
}

Points cloud(int count, bool on_sphere, Random& random) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d point = randomPoint(random, 1.0);
    points.push_back(on_sphere && point.norm() > 1e-3 ? Eigen::Vector3d(point.normalized())
                                                      : point);
  }
  return points;
}

Points prism(int sides) {
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * M_PI * i / sides;
    for (const double z : {-1.0, 1.0}) {
      points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  }
  return points;
}

ConvexHull anyHull(const ConvexPoolRecipe& recipe, Random& random) {
  const Points forms[] = {cloud(4 + anyOf(12, random), false, random),
                          cloud(16 + anyOf(64, random), true, random), prism(3 + anyOf(20, random)),
                          prism(4)};
  Points points = forms[anyOf(4, random)];
  Eigen::Vector3d scale;
  const bool is_even = anyOf(2, random) == 0;
  for (double& factor : scale) {
    factor = anyLength(recipe, random);
  }
  if (is_even) {
    scale.setConstant(scale.maxCoeff());
  }
  const Eigen::Vector3d offset =
      anyOf(2, random) == 0 ? Eigen::Vector3d::Zero() : randomPoint(random, scale.maxCoeff());
  for (Eigen::Vector3d& point : points) {
    point = point.cwiseProduct(scale) + offset;
  }
  return ConvexHull(points);
}

ConvexGeometry anyGeometry(ConvexKind kind, const ConvexPoolRecipe& recipe, Random& random) {
  const double x = anyLength(recipe, random);
  const double y = anyLength(recipe, random);
  const double z = anyLength(recipe, random);
  const double radius = anyLength(recipe, random);
  switch (kind) {
    case ConvexKind::sphere:
      return Sphere{radius};
    case ConvexKind::capsule:
      return Capsule{z, radius};
    case ConvexKind::box:
      return Box{{x, y, z}};
    case ConvexKind::rounded_box:
      return RoundedBox{{x, y, z}, radius};
    case ConvexKind::cylinder:
      return Cylinder{z, radius};
    case ConvexKind::hull:
      return anyHull(recipe, random);
    case ConvexKind::half_space:
      break;
  }
  return HalfSpace{};
}

Eigen::Matrix3d anyTurn(Alignment alignment, Random& random) {
  if (alignment == Alignment::random) {
    return randomRotation(random);
  }
  Eigen::Matrix3d turns = Eigen::Matrix3d::Identity();
  for (int i = anyOf(4, random); i > 0; --i) {
    turns = (anyOf(2, random) == 0 ? axes(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ())
                                   : axes(Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitX())) *
            turns;
  }
  if (alignment == Alignment::near_parallel) {
    const double angle = std::exp(uniform(random, std::log(1e-16), std::log(1e-3)));
    turns = Eigen::AngleAxisd(angle, randomPoint(random, 1.0).normalized()) * turns;
  }
  return turns;
}

double wantedGap(Nearness nearness, Random& random) {
  const double sign = anyOf(2, random) == 0 ? 1.0 : -1.0;
  switch (nearness) {
    case Nearness::separated:
      return std::exp(uniform(random, std::log(1e-3), std::log(10.0)));
    case Nearness::near:
      return sign * std::exp(uniform(random, std::log(1e-6), std::log(1e-3)));
    case Nearness::touching:
      return anyOf(2, random) == 0
                 ? 0.0
                 : sign * std::exp(uniform(random, std::log(1e-16), std::log(1e-9)));
    case Nearness::overlapping:
      break;
  }
  return 0.0;
}

}  // namespace

const char* nameOf(ConvexKind kind) noexcept {
  constexpr const char* kNames[] = {"sphere",   "capsule", "box",       "rounded_box",
                                    "cylinder", "hull",    "half_space"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<ConvexGeometry> makeConvexPool(ConvexKind kind, std::size_t count,
                                           const ConvexPoolRecipe& recipe, Random& random) {
  std::vector<ConvexGeometry> pool;
  for (std::size_t i = 0; i < count; ++i) {
    pool.push_back(anyGeometry(kind, recipe, random));
  }
  return pool;
}

double extentOf(const ConvexGeometry& geometry) {
  struct {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Capsule& s) const { return s.radius + s.half_length; }
    double operator()(const Box& s) const { return s.half_extents.norm(); }
    double operator()(const RoundedBox& s) const { return s.half_extents.norm() + s.radius; }
    double operator()(const Cylinder& s) const { return std::hypot(s.half_length, s.radius); }
    double operator()(const ConvexHull& hull) const {
      double extent = 0.0;
      for (const Eigen::Vector3d& vertex : hull.vertices()) {
        extent = std::max(extent, vertex.norm());
      }
      return extent;
    }
    double operator()(const HalfSpace&) const { return 0.0; }
  } extent;
  return std::visit(extent, geometry);
}

PosedConvexPair placeConvexPair(const ConvexGeometry& a, const ConvexGeometry& b, Nearness nearness,
                                Alignment alignment, Random& random) {
  const bool in_world = alignment != Alignment::random && anyOf(2, random) == 0;
  PosedConvexPair pair{&a, in_world ? Pose{} : randomPose(random, 5.0), &b, Pose{}};
  Eigen::Vector3d offset = randomPoint(random, std::max(extentOf(a), extentOf(b)));
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (alignment != Alignment::random && anyOf(2, random) == 0) {
      offset[k] = 0.0;
    }
  }
  if (anyOf(20, random) == 0) {
    offset.setZero();
  }
  pair.world_from_b = pair.world_from_a * Pose{anyTurn(alignment, random), offset};
  if (nearness != Nearness::overlapping) {
    static thread_local ConvexWorkspace workspace;
    ConvexWarmStart warm;
    ConvexSearch search{workspace, warm};
    const ConvexDistance now =
        signedDistanceBetween(a, pair.world_from_a, b, pair.world_from_b, search);
    if (now.quality != Quality::unknown) {
      pair.world_from_b.translation +=
          (wantedGap(nearness, random) - now.measured.distance) * now.measured.normal_a_to_b;
    }
  }
  return pair;
}

std::string describe(const PosedConvexPair& pair) {
  std::ostringstream text;
  const Eigen::IOFormat flat(17, Eigen::DontAlignCols, ", ", ", ");
  const auto add = [&](const char* name, const ConvexGeometry& geometry, const Pose& pose) {
    text << std::setprecision(17) << name << ": kind " << geometry.index();
    if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
      text << " (cylinder), half length " << cylinder->half_length << ", radius "
           << cylinder->radius;
    } else if (const auto* hull = std::get_if<ConvexHull>(&geometry)) {
      text << " (hull)";
      for (const Eigen::Vector3d& vertex : hull->vertices()) {
        text << ", {" << vertex.transpose().format(flat) << "}";
      }
    } else if (const auto* box = std::get_if<Box>(&geometry)) {
      text << " (box), half extents " << box->half_extents.transpose().format(flat);
    } else if (const auto* rounded = std::get_if<RoundedBox>(&geometry)) {
      text << " (rounded box), half extents " << rounded->half_extents.transpose().format(flat)
           << ", radius " << rounded->radius;
    } else if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
      text << " (capsule), half length " << capsule->half_length << ", radius " << capsule->radius;
    } else if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
      text << " (sphere), radius " << sphere->radius;
    }
    text << ", rotation " << pose.rotation.format(flat) << ", translation "
         << pose.translation.transpose().format(flat) << '\n';
  };
  add("a", *pair.a, pair.world_from_a);
  add("b", *pair.b, pair.world_from_b);
  return text.str();
}

}  // namespace collision_monitor::test
