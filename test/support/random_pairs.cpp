// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/random_pairs.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "support/reference/reference_distance.h"

namespace collision_monitor::test {
namespace {

bool oneIn(int count, Random& random) {
  return std::uniform_int_distribution<int>(1, count)(random) == 1;
}

double logUniform(double low, double high, Random& random) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

double randomLength(const PairRecipe& recipe, Random& random) {
  if (recipe.with_zero_lengths && oneIn(5, random)) {
    return 0.0;
  }
  return logUniform(recipe.least_length, recipe.greatest_length, random);
}

Shape randomShape(ShapeKind kind, const PairRecipe& recipe, Random& random) {
  const auto length = [&] { return randomLength(recipe, random); };
  if (kind == ShapeKind::sphere) {
    return Sphere{length()};
  }
  if (kind == ShapeKind::capsule) {
    const double half_length = length();
    return Capsule{half_length, length()};
  }
  Eigen::Vector3d half_extents;
  for (double& half_extent : half_extents) {
    half_extent = length();
  }
  if (kind == ShapeKind::box) {
    return Box{half_extents};
  }
  return RoundedBox{half_extents, length()};
}

// One of the rotations that take axes to axes.
Eigen::Matrix3d quarterTurns(Random& random) {
  Eigen::Matrix3d turns = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Index axis = std::uniform_int_distribution<Eigen::Index>(0, 2)(random);
    Eigen::Matrix3d quarter = Eigen::Matrix3d::Zero();
    quarter(axis, axis) = 1.0;
    quarter((axis + 1) % 3, (axis + 2) % 3) = -1.0;
    quarter((axis + 2) % 3, (axis + 1) % 3) = 1.0;
    turns = quarter * turns;
  }
  return turns;
}

Eigen::Matrix3d relativeRotation(Alignment alignment, Random& random) {
  if (alignment == Alignment::random) {
    return randomRotation(random);
  }
  const Eigen::Matrix3d turns = quarterTurns(random);
  if (alignment == Alignment::aligned) {
    return turns;
  }
  const Eigen::Vector3d axis = oneIn(2, random)
                                   ? Eigen::Vector3d(Eigen::Vector3d::UnitZ())
                                   : Eigen::Vector3d(randomPoint(random, 1.0).normalized());
  return Eigen::AngleAxisd(logUniform(1e-16, 1e-3, random), axis).toRotationMatrix() * turns;
}

// Leaves the pair where it is, in place of a gap to make.
constexpr double kUnchanged = 1e9;

double wantedGap(Nearness nearness, const ShapePair& pair, Random& random) {
  switch (nearness) {
    case Nearness::separated:
      return logUniform(1e-3, 10.0, random);
    case Nearness::near: {
      const double gap = logUniform(1e-6, 1e-3, random);
      return oneIn(2, random) ? gap : -gap;
    }
    case Nearness::touching: {
      const double offset = oneIn(2, random) ? 0.0 : logUniform(1e-16, 1e-9, random);
      const double radii = radiusOf(pair.a) + radiusOf(pair.b);
      return oneIn(2, random) ? offset : -radii - offset;
    }
    case Nearness::overlapping:
      break;
  }
  return kUnchanged;
}

// A point that often shares coordinates with the origin, or with the faces of the shape there.
Eigen::Vector3d snapped(Eigen::Vector3d offset, const Eigen::Vector3d& half_extents,
                        Random& random) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (oneIn(3, random)) {
      offset[k] = oneIn(2, random) ? 0.0 : half_extents[k];
    }
  }
  return offset;
}

double reachOf(const Shape& shape) { return coreHalfExtents(shape).norm() + radiusOf(shape); }

}  // namespace

ShapePair randomPair(const PairRecipe& recipe, Random& random) {
  ShapePair pair;
  pair.a = randomShape(recipe.a, recipe, random);
  pair.b = randomShape(recipe.b, recipe, random);
  // Some aligned pairs use the world's own axes, where nothing is rounded.
  const bool in_world = recipe.alignment != Alignment::random && oneIn(2, random);
  pair.world_from_a = in_world ? Pose{} : randomPose(random, 10.0);
  const double reach = std::max(reachOf(pair.a), reachOf(pair.b)) + 1e-3;
  Eigen::Vector3d offset =
      oneIn(20, random) ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : randomPoint(random, reach);
  if (recipe.alignment != Alignment::random) {
    offset = snapped(offset, coreHalfExtents(pair.a), random);
  }
  pair.world_from_b = pair.world_from_a * Pose{relativeRotation(recipe.alignment, random), offset};

  const double gap = wantedGap(recipe.nearness, pair, random);
  if (gap != kUnchanged) {
    const Reference now = referenceDistance(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
    pair.world_from_b.translation += (gap - now.distance) * now.normal_a_to_b;
  }
  return pair;
}

const char* nameOf(ShapeKind kind) noexcept {
  constexpr const char* kNames[] = {"sphere", "capsule", "box", "rounded_box"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* nameOf(Nearness nearness) noexcept {
  constexpr const char* kNames[] = {"separated", "near", "touching", "overlapping"};
  return kNames[static_cast<std::size_t>(nearness)];
}

const char* nameOf(Alignment alignment) noexcept {
  constexpr const char* kNames[] = {"random", "aligned", "near_parallel"};
  return kNames[static_cast<std::size_t>(alignment)];
}

std::string describe(const ShapePair& pair) {
  std::ostringstream text;
  text << std::setprecision(17);
  const Eigen::IOFormat flat(17, Eigen::DontAlignCols, ", ", ", ");
  const auto add = [&](const char* name, const Shape& shape, const Pose& pose) {
    text << name << ": " << kindName(shape) << ", core half extents "
         << coreHalfExtents(shape).transpose().format(flat) << ", radius " << radiusOf(shape)
         << ", rotation " << pose.rotation.format(flat) << ", translation "
         << pose.translation.transpose().format(flat) << '\n';
  };
  add("a", pair.a, pair.world_from_a);
  add("b", pair.b, pair.world_from_b);
  return text.str();
}

}  // namespace collision_monitor::test
