// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_monitor/fitting/enclose.h"
#include "fitting/proofs/proof.h"
#include "fitting/shapes/fit_box.h"
#include "fitting/shapes/fit_capsule.h"
#include "fitting/shapes/fit_rounded_box.h"
#include "fitting/shapes/fit_sphere.h"
#include "support/fixed_seed.h"
#include "support/reference/extended_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using test::extendedDistance;

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

Eigen::Vector3d vector(double reach) {
  return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
}

/// From needles to blobs, also flat, anywhere within 10 m.
TriangleMesh anyCloud() {
  const Eigen::Vector3d half_extents(between(0.0, 0.5), between(0.0, 0.5), between(0.001, 0.5));
  const int count = *rc::gen::inRange(3, 80);
  const auto seed = *rc::gen::inRange(0u, 1000000u);
  return test::moved(test::randomCloud(half_extents, count, seed), vector(3.0), vector(10.0));
}

RC_GTEST_PROP(EnclosureLaws, everyVertexIsInside_inExtendedPrecision, ()) {
  const TriangleMesh mesh = anyCloud();
  const Enclosure enclosure = encloseTightly(mesh);
  RC_ASSERT(enclosure.widening < 1e-9);
  RC_ASSERT(isRigid(enclosure.geometry_from_body, 1e-12));
  for (const auto& vertex : mesh.vertices) {
    RC_ASSERT(extendedDistance(enclosure.shape, enclosure.geometry_from_body, vertex) <= 0.0L);
  }
}

RC_GTEST_PROP(EnclosureLaws, everyCylinderRimIsInside, ()) {
  const Cylinder cylinder{between(0.0, 1.0), between(0.0, 1.0)};
  const Enclosure enclosure = encloseTightly(cylinder);
  for (int i = 0; i < 360; ++i) {
    const double angle = i * 3.14159265358979 / 180.0;
    // Slightly inside: the sine and cosine of the test are rounded too.
    const double radius = cylinder.radius * (1.0 - 1e-15);
    const Eigen::Vector3d rim(radius * std::cos(angle), radius * std::sin(angle),
                              cylinder.half_length);
    RC_ASSERT(extendedDistance(enclosure.shape, enclosure.geometry_from_body, rim) <= 0.0L);
  }
}

RC_GTEST_PROP(EnclosureLaws, provenExcess_isNeverBelowTheTruth, ()) {
  const Points points = anyCloud().vertices;
  PosedShape fit = fitBox(points);
  fit.shape = RoundedBox{coreHalfExtents(fit.shape) * between(0.5, 1.5), between(0.0, 0.2)};
  long double truth = -1.0L;
  for (const auto& point : points) {
    truth = std::max(truth, extendedDistance(fit.shape, fit.geometry_from_body, point));
  }
  const double bound = provenExcess(fit, points);
  RC_ASSERT(static_cast<long double>(bound) >= truth);
  RC_ASSERT(static_cast<long double>(bound) <= truth + 1e-12L);
}

RC_GTEST_PROP(EnclosureLaws, rigidMotion_changesNoVolumeByMoreThanAFraction, ()) {
  const TriangleMesh mesh = anyCloud();
  const TriangleMesh other = test::moved(mesh, vector(3.0), vector(5.0));
  // A thin set has a volume near zero, whose ratio means nothing: add a tenth of a millimetre.
  const auto thickened = [](const PosedShape& fit) { return volumeOf(grown(fit.shape, 1e-4)); };
  for (const auto fit : {fitSphere, fitCapsule, fitBox}) {
    const double volume = thickened(fit(mesh.vertices));
    const double volume_moved = thickened(fit(other.vertices));
    RC_ASSERT(std::abs(volume - volume_moved) <= 0.02 * volume);
  }
}

RC_GTEST_PROP(EnclosureLaws, roundedBoxIsLeast_andNoCapsuleOfTheTestIsSmaller, ()) {
  const Points points = anyCloud().vertices;
  const double rounded = volumeOf(fitRoundedBox(points).shape);
  RC_ASSERT(rounded <= volumeOf(fitBox(points).shape));
  RC_ASSERT(rounded <= volumeOf(fitCapsule(points).shape));
  RC_ASSERT(rounded <= volumeOf(fitSphere(points).shape));
  // Any segment, with the radius that it needs, is a capsule that holds all.
  PosedShape any{Capsule{between(0.0, 0.5), 0.0}, fitBox(points).geometry_from_body};
  any.shape = grown(any.shape, excessOver(any, points));
  RC_ASSERT(volumeOf(fitCapsule(points).shape) <= 1.001 * volumeOf(any.shape) + 1e-12);
}

}  // namespace
}  // namespace collision_monitor
