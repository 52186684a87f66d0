// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "support/convex_cases.h"
#include "support/reference/convex_measure.h"

// Pairs that the stress program found: distances were right, and one of the points was off its
// geometry. On a curved surface another plane may be as good as that of the face the points come
// from, with a normal that differs by half the digits.
namespace collision_monitor::test {
namespace {

double worstOutside(const PosedConvexPair& pair) {
  const ConvexDistance found = measureCold(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b);
  EXPECT_EQ(found.quality, Quality::exact);
  const ConvexCertificate proof = certify(pair, found.measured);
  return std::max(proof.a_outside, proof.b_outside);
}

TEST(WitnessPoints, largeCylinderInAPlate_pointsAreInBoth) {
  Pose pose_a;
  pose_a.rotation << 0.99416394752117421, -0.068877227402281582, 0.08302995239364197,
      0.055502984906702947, 0.98653993502829695, 0.15381279290361369, -0.092506562554028365,
      -0.14830672317780483, 0.98460532790793875;
  pose_a.translation << 3.0500251239270817, 1.3710588042442406, 4.8173776212316657;
  Pose pose_b;
  pose_b.rotation << 0.7243589294525018, 0.68751831978970512, -0.051212315666900966,
      0.67939531021231325, -0.69922747554710019, 0.22249258392482291, 0.1171586692649759,
      -0.19595789699211075, -0.97358838778124812;
  pose_b.translation << -124.47408071553876, -195.33130270266054, 37.092886242395672;
  const ConvexGeometry cylinder = Cylinder{64.412273061829197, 263.20097961242908};
  const double x = 41.595715861774394;
  const double z = 23.890738124861379;
  const ConvexGeometry plate = ConvexHull({{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}});
  EXPECT_LE(worstOutside({&cylinder, pose_a, &plate, pose_b}), 1e-6);  // it was 7e-4
}

TEST(WitnessPoints, discTouchingAPrism_pointsAreInBoth) {
  const ConvexGeometry disc = Cylinder{0.0093159527418820061, 0.083339678415372875};
  const double low = -5.477725212932862;
  const double high = 0.54788236464674833;
  std::vector<Eigen::Vector3d> corners;
  for (const double height : {low, high}) {
    corners.emplace_back(2.4809005722504254, -2.7487434072728276, height);
    corners.emplace_back(5.4937043610402307, 0.2640603815169773, height);
    corners.emplace_back(-0.53190321653937911, 0.26406038151697769, height);
    corners.emplace_back(2.4809005722504258, 3.2768641703067822, height);
  }
  const ConvexGeometry prism = ConvexHull(corners);
  Pose pose_b;
  pose_b.rotation = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  pose_b.translation << 1.5651847338513405, 2.4790084354060982, -0.55719831738854231;
  // It was 7e-6: the search for the distance had stalled that far off, and its points were taken.
  EXPECT_LE(worstOutside({&disc, {}, &prism, pose_b}), 1e-12);
}

TEST(WitnessPoints, besideEachOtherAlongOneAxis_pointsAreInWhatBothShare) {
  // Parallel but for rounding; of each, one end is beyond the other, and a point was taken there.
  Pose pose_a;
  pose_a.rotation << -0.72726364110388619, -0.67216364980869625, 0.13886548960836215,
      -0.1884283968827048, 0.00098072478215105452, -0.98208644091399389, 0.65998661772533818,
      -0.74040196248710333, -0.1273679644522685;
  pose_a.translation << -2.832608823622615, -3.3978457528074526, 2.6909633722587909;
  Pose pose_b;
  pose_b.rotation << -0.72726364110385999, -0.67216364980872811, 0.13886548960834535,
      -0.1884283968827051, 0.00098072478216852492, -0.98208644091399377, 0.65998661772536704,
      -0.74040196248707435, -0.12736796445228737;
  pose_b.translation << -2.8325702803625461, -3.3981183389856962, 2.6909280202315005;
  const ConvexGeometry capsule = Capsule{0.00025402465354495556, 2.2563152579300191e-05};
  const ConvexGeometry cylinder = Cylinder{0.00034062606624669456, 4.4065500465759982e-06};
  EXPECT_LE(worstOutside({&capsule, pose_a, &cylinder, pose_b}), 1e-12);  // it was 1e-5
}

}  // namespace
}  // namespace collision_monitor::test
