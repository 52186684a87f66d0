// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/time_of_contact.h"

#include <gtest/gtest.h>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

void expectTime(const std::optional<double>& found, double expected) {
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, expected, kExact);
}

TEST(TimeOfContact, spheresHeadOn_gapOverTravel) {
  // 3 m between the surfaces of 1 m and 0.5 m spheres, 6 m of travel.
  expectTime(timeOfContact(Sphere{1.0}, Pose(), Sphere{0.5}, at(4.5, 0, 0), {-6, 0, 0}), 0.5);
}

TEST(TimeOfContact, spheresOffCenter_hypotenuseIsTheSumOfRadii) {
  // Centers 5 m apart when touching: 4 aside, so 3 ahead; the center goes from 13 to 3.
  expectTime(timeOfContact(Sphere{2.0}, Pose(), Sphere{3.0}, at(13, 4, 0), {-20, 0, 0}), 0.5);
}

TEST(TimeOfContact, spheresThatPassOrPartOrStopShort_never) {
  EXPECT_FALSE(timeOfContact(Sphere{2.0}, Pose(), Sphere{3.0}, at(13, 5.001, 0), {-20, 0, 0}));
  EXPECT_FALSE(timeOfContact(Sphere{2.0}, Pose(), Sphere{3.0}, at(13, 4, 0), {20, 0, 0}));
  EXPECT_FALSE(timeOfContact(Sphere{2.0}, Pose(), Sphere{3.0}, at(13, 4, 0), {-9.999, 0, 0}));
  EXPECT_FALSE(timeOfContact(Sphere{2.0}, Pose(), Sphere{3.0}, at(13, 4, 0), {0, 0, 0}));
}

TEST(TimeOfContact, overlapAtTheStart_atZeroWhateverTheTravel) {
  expectTime(timeOfContact(Sphere{1.0}, Pose(), Sphere{1.0}, at(1.9, 0, 0), {5, 0, 0}), 0.0);
  expectTime(timeOfContact(HalfSpace{}, Pose(), Sphere{1.0}, at(0, 0, 0.5), {0, 0, 5}), 0.0);
  expectTime(timeOfContact(HalfSpace{}, Pose(), Box{{1, 1, 1}}, at(0, 0, 0.5), {0, 0, 5}), 0.0);
  expectTime(timeOfContact(Box{{1, 1, 1}}, Pose(), Box{{1, 1, 1}}, at(1.5, 1.5, 0), {9, 0, 0}),
             0.0);
}

TEST(TimeOfContact, grazingSpheres_keepTheirDigits) {
  // 1e-9 m from missing: the chord is sqrt(2 * 1e-9) m long on either side, to first order.
  const double aside = 1.0 - 1e-9;
  const double half_chord = std::sqrt((1.0 - aside) * (1.0 + aside));
  expectTime(timeOfContact(Sphere{0.5}, Pose(), Sphere{0.5}, at(1, aside, 0), {-2, 0, 0}),
             0.5 - 0.5 * half_chord);
}

TEST(TimeOfContact, sphereFallsOnAPlane) {
  // The plane x = 1 with its solid below x: the center falls from 4 to 1.25.
  const Pose plane{axes(Vector3d::UnitY(), Vector3d::UnitZ()), {1, 7, 7}};
  expectTime(timeOfContact(HalfSpace{}, plane, Sphere{0.25}, at(4, 0, 0), {-11, 3, 2}), 0.25);
  EXPECT_FALSE(timeOfContact(HalfSpace{}, plane, Sphere{0.25}, at(4, 0, 0), {-2.7, 3, 2}));
  EXPECT_FALSE(timeOfContact(HalfSpace{}, plane, Sphere{0.25}, at(4, 0, 0), {0, 3, 2}));
}

TEST(TimeOfContact, boxOnEdgeFallsOnAPlane) {
  // Turned by 45 degrees about z, then laid so that the edge points down x: reach sqrt(2).
  const Pose plane{axes(Vector3d::UnitY(), Vector3d::UnitZ()), Vector3d::Zero()};
  const Pose box{eighthTurn(), {3, 0, 0}};
  expectTime(timeOfContact(HalfSpace{}, plane, Box{{1, 1, 5}}, box, {-4, 0, 0}),
             (3.0 - std::sqrt(2.0)) / 4.0);
}

TEST(TimeOfContact, alignedBoxes_theLastAxisToCloseDecides) {
  // Gaps 1 and 2 along x and y; x closes at 1/4, y at 1/2; both stay closed until then.
  expectTime(timeOfContact(Box{{1, 1, 1}}, Pose(), Box{{1, 1, 1}}, at(3, 4, 0), {-4, -4, 0}), 0.5);
  // x opens again (at 3/4, having closed at 1/8) before y closes, at 1.
  EXPECT_FALSE(timeOfContact(Box{{1, 1, 1}}, Pose(), Box{{1, 1, 1}}, at(3, 4, 0), {-8, -2, 0}));
  // An axis along which nothing moves and which parts them.
  EXPECT_FALSE(timeOfContact(Box{{1, 1, 1}}, Pose(), Box{{1, 1, 1}}, at(3, 2.5, 0), {-4, 0, 0}));
}

TEST(TimeOfContact, boxesMeetEdgeToEdge_onlyTheCrossedEdgesTell) {
  // A's edge along z points to +x, B's edge along y to -x, both of reach sqrt(2).
  const Pose a{eighthTurn(), Vector3d::Zero()};
  const double s = std::sqrt(0.5);
  const Pose b{axes({s, 0, s}, Vector3d::UnitY()), {5, 0, 0}};
  expectTime(timeOfContact(Box{{1, 1, 9}}, a, Box{{1, 9, 1}}, b, {-5, 0, 0}),
             (5.0 - 2.0 * std::sqrt(2.0)) / 5.0);
}

TEST(TimeOfContact, thinPlatesThatChangeSides_areCaught) {
  const Box plate{{0.5, 0.5, 0.0005}};
  expectTime(timeOfContact(plate, Pose(), plate, at(0, 0, 0.1), {0, 0, -0.2}), 0.495);
}

}  // namespace
}  // namespace collision_monitor::test
