// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "collision_monitor/fitting/enclose.h"
#include "fitting/proofs/proof.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// The largest signed distance of densely sampled rim points: an independent look at containment.
double excessOfRims(const Cylinder& cylinder, const Shape& shape) {
  double excess = -1.0;
  for (int i = 0; i < 3600; ++i) {
    const double angle = 2.0 * kPi * i / 3600;
    const double x = cylinder.radius * std::cos(angle);
    const double y = cylinder.radius * std::sin(angle);
    excess = std::max(excess, signedDistanceTo(shape, {x, y, cylinder.half_length}));
    excess = std::max(excess, signedDistanceTo(shape, {x, y, -cylinder.half_length}));
  }
  return excess;
}

TEST(EncloseCylinder, everyProportion_isHeldAndTouched) {
  for (const double radius : {0.0, 0.01, 0.05, 0.2, 1.0}) {
    for (const double half_length : {0.0, 0.01, 0.1, 0.5}) {
      const Cylinder cylinder{half_length, radius};
      const Enclosure enclosure = encloseTightly(cylinder);
      const PosedShape fit{enclosure.shape, enclosure.geometry_from_body};
      EXPECT_LE(provenExcess(fit, cylinder), 0.0) << radius << " " << half_length;
      EXPECT_LE(excessOfRims(cylinder, enclosure.shape), 0.0) << radius << " " << half_length;
      EXPECT_GE(excessOfRims(cylinder, enclosure.shape), -1e-12) << radius << " " << half_length;
      EXPECT_LE(enclosure.widening, 1e-13);
      EXPECT_FALSE(enclosure.is_exact);
    }
  }
}

TEST(EncloseCylinder, longAndThin_isACapsuleALittleLongerThanTheCylinder) {
  const Enclosure enclosure = encloseTightly(Cylinder{0.5, 0.008});
  const auto* capsule = std::get_if<Capsule>(&enclosure.shape);
  ASSERT_NE(capsule, nullptr);
  EXPECT_LT(capsule->half_length, 0.5);
  EXPECT_NEAR(capsule->radius, std::hypot(0.008, 0.5 - capsule->half_length), 1e-12);
  EXPECT_LT(enclosure.overshoot.mean, 0.001);
}

TEST(EncloseCylinder, disc_isAFlatBox) {
  const Enclosure enclosure = encloseTightly(Cylinder{0.0, 0.1});
  EXPECT_LT(coreHalfExtents(enclosure.shape).z() + radiusOf(enclosure.shape), 1e-12);
  // The corner of the square is (sqrt(2) - 1) R away.
  EXPECT_NEAR(enclosure.overshoot.max, 0.1 * (std::sqrt(2.0) - 1.0), 1e-9);
}

TEST(ProvenExcess, cylinderInABoxTooSmall_isTheGap) {
  const Cylinder cylinder{0.5, 0.2};
  EXPECT_NEAR(provenExcess({Box{{0.2, 0.1, 0.5}}, {}}, cylinder), 0.1, 1e-12);
  EXPECT_NEAR(provenExcess({Box{{0.2, 0.2, 0.4}}, {}}, cylinder), 0.1, 1e-12);
  EXPECT_NEAR(provenExcess({Box{{0.3, 0.3, 0.6}}, {}}, cylinder), -0.1, 1e-12);
}

TEST(ProvenExcess, cylinderInACapsule_isTheRimsDistance) {
  EXPECT_NEAR(provenExcess({Capsule{0.1, 0.1}, {}}, Cylinder{0.5, 0.3}), 0.4, 1e-12);
}

}  // namespace
}  // namespace collision_monitor
