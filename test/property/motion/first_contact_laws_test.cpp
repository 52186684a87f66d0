// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "motion/conservative_advancement.h"
#include "motion/moving_sphere.h"
#include "motion/time_of_contact.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/reference/convex_measure.h"
#include "support/robots/random_motions.h"

namespace collision_monitor::test {
namespace {

constexpr double kDistance = 1e-6;

std::uint64_t anySeed() { return *rc::gen::inRange<std::uint64_t>(0, 1ULL << 40); }

struct Scene {
  ConvexGeometry a;
  ScrewMotion motion_a;
  ConvexGeometry b;
  ScrewMotion motion_b;

  double distanceAt(double time) const {
    return measureCold(a, poseAt(motion_a, time), b, poseAt(motion_b, time)).measured.distance;
  }
  SweptContact meet(double contact_distance = 0.0) const {
    return meetConvex(a, motion_a, b, motion_b, contact_distance);
  }
};

/// Two bodies of decimetres within a metre, which move by decimetres and turn by up to 2 rad.
Scene anyScene(Random& random) {
  const ConvexGeometry a = randomGeometry(random);
  const ScrewMotion motion_a = randomMotion(random, 0.7, 0.3, 2.0);
  const ConvexGeometry b = randomGeometry(random);
  return {a, motion_a, b, randomMotion(random, 0.7, 0.3, 2.0)};
}

/// What an answer says, held to distances at `count` times that conservative advancement did not
/// choose.
void expectTrue(const SweptContact& found, double contact_distance, int count, const Scene& scene) {
  RC_ASSERT(found.state == SweepState::clear || found.state == SweepState::contact);
  for (int i = 0; i <= count; ++i) {
    const double time = found.time * i / count;
    if (found.state == SweepState::clear || (found.time - time) > 1e-6) {
      RC_ASSERT(scene.distanceAt(time) > contact_distance - 1e-9);
    }
  }
  if (found.state == SweepState::contact) {
    RC_ASSERT(scene.distanceAt(found.time) <= contact_distance + kDistance);
  }
}

RC_GTEST_PROP(FirstContactLaws, convexBodies_clearBeforeAndNearAtTheTime, ()) {
  Random random(anySeed());
  const Scene scene = anyScene(random);
  const double contact_distance = *rc::gen::element(0.0, 0.0, 0.05);
  RC_PRE(scene.distanceAt(0.0) > contact_distance);
  expectTrue(scene.meet(contact_distance), contact_distance, 300, scene);
}

RC_GTEST_PROP(FirstContactLaws, oneMoreMotionOfTheWorld_changesNothing, ()) {
  Random random(anySeed());
  const Scene scene = anyScene(random);
  Scene moved = scene;
  const Pose world = randomPose(random, 2.0);
  for (ScrewMotion* motion : {&moved.motion_a, &moved.motion_b}) {
    motion->start = world * motion->start;
    motion->turn = world.rotation * motion->turn;
    motion->travel = world.rotation * motion->travel;
  }
  const SweptContact found = moved.meet();
  RC_ASSERT(found.state == scene.meet().state);
  if (found.state == SweepState::contact) {
    RC_ASSERT(scene.distanceAt(found.time) <= kDistance);
  }
}

RC_GTEST_PROP(FirstContactLaws, swappedBodies_meetAtATimeThatIsAsGood, ()) {
  Random random(anySeed());
  const Scene scene = anyScene(random);
  const Scene swapped{scene.b, scene.motion_b, scene.a, scene.motion_a};
  const SweptContact found = swapped.meet();
  RC_ASSERT(found.state == scene.meet().state);
  if (found.state == SweepState::contact) {
    RC_ASSERT(scene.distanceAt(found.time) <= kDistance);
  }
}

RC_GTEST_PROP(FirstContactLaws, straightMotions_closedFormsAgreeWithAdvancement, ()) {
  Random random(anySeed());
  Scene scene = anyScene(random);
  if (*rc::gen::arbitrary<bool>()) {
    scene.a = Box{{0.1, 0.2, 0.05}};
    scene.b = Box{{0.3, 0.02, 0.15}};
  } else {
    scene.a = Sphere{0.2};
    scene.b =
        *rc::gen::arbitrary<bool>() ? ConvexGeometry(Sphere{0.1}) : ConvexGeometry(HalfSpace{});
  }
  scene.motion_a.turn.setZero();
  scene.motion_b.turn.setZero();
  const SweptContact straight = scene.meet();
  // So little that it counts as depth and not as time, yet no closed form is taken.
  const SweptContact advanced = scene.meet(1e-12);
  RC_ASSERT(straight.state == advanced.state);
  RC_ASSERT(straight.work <= 1U);
  if (straight.state == SweepState::contact) {
    RC_ASSERT(scene.distanceAt(advanced.time) <= kDistance);
    RC_ASSERT(advanced.time <= straight.time + 1e-9);
  }
}

RC_GTEST_PROP(FirstContactLaws, sweptBounds_holdTheBodyAndMissNoContact, ()) {
  Random random(anySeed());
  const Shape a = randomShape(random);
  const Shape b = randomShape(random);
  const ScrewMotion motion_a = randomMotion(random, 0.7, 0.3, 2.0);
  const ScrewMotion motion_b = randomMotion(random, 0.7, 0.3, 2.0);
  const MovingSphere ball = movingSphereOf(motion_a, Eigen::Vector3d::Zero(), boundingRadius(a));
  const MovingSphere other = movingSphereOf(motion_b, Eigen::Vector3d::Zero(), boundingRadius(b));
  const Aabb box = sweptAabbOf(a, motion_a, poseAt(motion_a, 1.0), 0.0);
  for (int i = 0; i <= 20; ++i) {
    const Pose pose = poseAt(motion_a, 0.05 * i);
    const Aabb now = aabbOf(a, pose, 0.0);
    RC_ASSERT((now.min.array() >= box.min.array() - 1e-12).all());
    RC_ASSERT((now.max.array() <= box.max.array() + 1e-12).all());
    const Eigen::Vector3d center = ball.center + 0.05 * i * ball.travel;
    RC_ASSERT((pose.translation - center).norm() + boundingRadius(a) <= ball.reach + 1e-12);
  }
  const SweptContact found = firstContact({a, motion_a}, {b, motion_b}, SweepLimits());
  if (found.state == SweepState::contact) {
    RC_ASSERT(meets(box, sweptAabbOf(b, motion_b, poseAt(motion_b, 1.0), 0.0)));
    RC_ASSERT(mayMeetBySpeed(ball, other, 0.0));
    RC_ASSERT(mayMeetByClosing(ball, other, 0.0));
  }
}

/// What is known to be clear at the end is not looked at, and everything before it is.
template <class Meet>
void expectNothingElseUntil(double until, const SweptContact& found, SweepLimits limits,
                            const Meet& meet) {
  constexpr double kTime = 1e-6;
  RC_PRE(found.state == SweepState::clear || std::abs(found.time - until) > kTime);
  limits.until = until;
  const SweptContact before = meet(limits);
  if (found.state == SweepState::contact && found.time < until) {
    RC_ASSERT(before.state == SweepState::contact);
    RC_ASSERT(std::abs(before.time - found.time) < kTime);
  } else {
    RC_ASSERT(before.state == SweepState::clear);
  }
}

/// As expectTrue, for what `meet` and `distance_at` say of meshes.
template <class Meet, class DistanceAt>
void expectTrueOfMeshes(const Meet& meet, const DistanceAt& distance_at) {
  RC_PRE(distance_at(0.0) > kDistance);
  SweepLimits limits;
  limits.budget = 1000000;
  const SweptContact found = meet(limits);
  RC_ASSERT(found.state == SweepState::clear || found.state == SweepState::contact);
  constexpr int kCount = 50;
  for (int i = 0; i < kCount; ++i) {
    RC_ASSERT(distance_at((found.time - 1e-6) * i / kCount) > 0.0);
  }
  if (found.state == SweepState::contact) {
    RC_ASSERT(distance_at(found.time) <= kDistance);
  }
  expectNothingElseUntil(0.01 * *rc::gen::inRange(1, 100), found, limits, meet);
}

RC_GTEST_PROP(FirstContactLaws, meshes_clearBeforeAndNearAtTheTime, ()) {
  static const MeshTree tree_a(bumpyMesh(0.4, 10), true);
  static const MeshTree tree_b(bumpyMesh(0.2, 8), true);
  static const auto memory = std::make_unique<MeshQueryMemory>();
  Random random(anySeed());
  const ScrewMotion motion_a = randomMotion(random, 0.4, 0.3, 2.0);
  const ScrewMotion motion_b = randomMotion(random, 0.4, 0.3, 2.0);
  expectTrueOfMeshes(
      [&](const SweepLimits& limits) {
        return firstContact({tree_a, motion_a}, {tree_b, motion_b}, limits, *memory);
      },
      [&](double time) {
        const Pose pose_a = poseAt(motion_a, time);
        const Pose pose_b = poseAt(motion_b, time);
        return distanceBetween(PlacedMesh{tree_a, pose_a}, PlacedMesh{tree_b, pose_b}, *memory)
            .measured.distance;
      });
}

RC_GTEST_PROP(FirstContactLaws, meshAndShape_clearBeforeAndNearAtTheTime, ()) {
  static const MeshTree tree(bumpyMesh(0.4, 10), true);
  static const auto memory = std::make_unique<MeshQueryMemory>();
  Random random(anySeed());
  const Shape shape = randomShape(random);
  const ScrewMotion motion_a = randomMotion(random, 0.4, 0.3, 2.0);
  const ScrewMotion motion_b = randomMotion(random, 0.4, 0.3, 2.0);
  expectTrueOfMeshes(
      [&](const SweepLimits& limits) {
        return firstContact({tree, motion_a}, {shape, motion_b}, limits, *memory);
      },
      [&](double time) {
        const Pose pose_a = poseAt(motion_a, time);
        const Pose pose_b = poseAt(motion_b, time);
        return distanceBetween(PlacedMesh{tree, pose_a}, PlacedShape{shape, pose_b}, *memory)
            .measured.distance;
      });
}

}  // namespace
}  // namespace collision_monitor::test
