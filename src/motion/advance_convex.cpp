// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <type_traits>

#include "geometry/bvh/visit_held.h"
#include "motion/advance.h"
#include "motion/time_of_contact.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {
namespace {

Sighting sight(const ConvexDistance& found, const SweepLimits& limits) noexcept {
  Sighting seen;
  seen.measured = found.measured;
  seen.gap = found.measured.distance - limits.contact_distance;
  seen.has_plane = found.quality == Quality::exact;
  if (found.quality == Quality::unknown) {
    seen.state = SweepState::unknown;
  } else if (seen.gap > limits.tolerance) {
    seen.state = SweepState::clear;
  } else {
    seen.state = seen.has_plane ? SweepState::contact : SweepState::undecided;
  }
  return seen;
}

/// The result of straight motion, for pairs with a closed form.
struct StraightContact {
  bool has_form{false};
  std::optional<double> time;
};

struct MeetStraight {
  const Pose& world_from_a;
  const Pose& world_from_b;
  const Eigen::Vector3d travel;  ///< of B relative to A

  template <class A, class B>
  StraightContact operator()(const A& a, const B& b) const noexcept {
    constexpr bool kIsSphere = std::is_same_v<B, Sphere>;
    constexpr bool kIsBox = std::is_same_v<B, Box>;
    if constexpr ((std::is_same_v<A, HalfSpace> && (kIsSphere || kIsBox)) ||
                  (std::is_same_v<A, Sphere> && kIsSphere) || (std::is_same_v<A, Box> && kIsBox)) {
      return {true, timeOfContact(a, world_from_a, b, world_from_b, travel)};
    } else if constexpr (std::is_same_v<B, HalfSpace> && !std::is_same_v<A, HalfSpace>) {
      return MeetStraight{world_from_b, world_from_a, -travel}(b, a);
    } else {
      return {};
    }
  }
};

template <class GeometryA, class GeometryB>
StraightContact meetStraight(const GeometryA& a, const ScrewMotion& motion_a, const GeometryB& b,
                             const ScrewMotion& motion_b) noexcept {
  const MeetStraight meet{motion_a.start, motion_b.start, motion_b.travel - motion_a.travel};
  const auto with_a = [&](const auto& held_a) noexcept {
    return visitHeld([&](const auto& held_b) noexcept { return meet(held_a, held_b); }, b);
  };
  return visitHeld(with_a, a);
}

/// Skips ahead for straight motion with a closed form: to the contact, which the distance there has
/// to confirm, or to the end.
template <class Geometry>
bool skipToContact(const Geometry& a, const ScrewMotion& motion_a, const Geometry& b,
                   const ScrewMotion& motion_b, SweepLimits& limits) noexcept {
  if (limits.contact_distance != 0.0 || !motion_a.turn.isZero(0.0) || !motion_b.turn.isZero(0.0) ||
      !isFinite(motion_a) || !isFinite(motion_b)) {
    return false;
  }
  const StraightContact straight = meetStraight(a, motion_a, b, motion_b);
  if (straight.time) {
    limits.from = std::max(limits.from, *straight.time);
  }
  return straight.has_form && !straight.time;
}

SweptContact clearThroughout() noexcept {
  SweptContact clear;
  clear.state = SweepState::clear;
  clear.time = 1.0;
  return clear;
}

}  // namespace

Ball ballOf(const Shape& shape) noexcept {
  return {Eigen::Vector3d::Zero(), boundingRadius(shape)};
}

Ball ballOf(const ConvexGeometry& geometry) noexcept {
  const auto of_held = [](const auto& held) noexcept -> Ball {
    using Held = std::decay_t<decltype(held)>;
    if constexpr (std::is_same_v<Held, HalfSpace>) {
      return {Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
    } else if constexpr (std::is_same_v<Held, Cylinder>) {
      return ballOf(Shape(Box{{held.radius, 0.0, held.half_length}}));
    } else if constexpr (std::is_same_v<Held, ConvexHull>) {
      Eigen::Vector3d least = held.vertices().front();
      Eigen::Vector3d greatest = least;
      for (const Eigen::Vector3d& vertex : held.vertices()) {
        least = least.cwiseMin(vertex);
        greatest = greatest.cwiseMax(vertex);
      }
      Ball ball{0.5 * (least + greatest), 0.0};
      for (const Eigen::Vector3d& vertex : held.vertices()) {
        ball.radius = std::max(ball.radius, (vertex - ball.center).norm());
      }
      return ball;
    } else {
      return ballOf(Shape(held));
    }
  };
  return visitHeld(of_held, geometry);
}

SweptContact firstContact(const MovingShape& a, const MovingShape& b,
                          const SweepLimits& limits) noexcept {
  SweepLimits rest = limits;
  if (skipToContact(a.shape, a.motion, b.shape, b.motion, rest)) {
    return clearThroughout();
  }
  const Ball ball_a = ballOf(a.shape);
  const Ball ball_b = ballOf(b.shape);
  const auto look = [&](double time, std::uint32_t /*budget*/) noexcept {
    const SignedDistance measured =
        distanceBetween(a.shape, poseAt(a.motion, time), b.shape, poseAt(b.motion, time));
    return sight({measured, Quality::exact}, limits);
  };
  return advance({ball_a, a.motion}, {ball_b, b.motion}, rest, look);
}

SweptContact firstContact(const MovingConvex& a, const MovingConvex& b, const SweepLimits& limits,
                          ConvexSearch& search) noexcept {
  SweepLimits rest = limits;
  if (skipToContact(a.geometry, a.motion, b.geometry, b.motion, rest)) {
    return clearThroughout();
  }
  const auto look = [&](double time, std::uint32_t /*budget*/) noexcept {
    return sight(signedDistanceBetween(a.geometry, poseAt(a.motion, time), b.geometry,
                                       poseAt(b.motion, time), search),
                 limits);
  };
  return advance({a.ball, a.motion}, {b.ball, b.motion}, rest, look);
}

}  // namespace collision_monitor
