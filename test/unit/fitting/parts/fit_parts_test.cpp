// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/constants.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::boxMesh;
using test::boxMeshAt;
using test::joined;
using test::moved;
using test::prismMesh;

/// Two bars of 0.4 x 0.1 x 0.1 m that share a corner cube.
TriangleMesh angleIron() {
  return joined(boxMesh({0.2, 0.05, 0.05}),
                moved(boxMesh({0.05, 0.15, 0.05}), Vector3d::Zero(), {-0.15, 0.2, 0.0}));
}

FitLimits upTo(std::uint32_t max_shapes, double target_overshoot = 0.0) {
  FitLimits limits;
  limits.max_shapes = max_shapes;
  limits.target_overshoot = target_overshoot;
  return limits;
}

void expectProven(const Geometry& geometry, const Fit& fit) {
  EXPECT_LE(provenExcess(geometry, fit), 0.0);
  EXPECT_EQ(fit.cuts.size() + 1, fit.shape_of.empty() ? fit.shapes.size() : fit.shape_of.size());
  EXPECT_GE(fit.overshoot.max, fit.overshoot.mean);
  for (const auto& enclosure : fit.shapes) {
    EXPECT_LT(enclosure.widening, 1e-9);
  }
}

TEST(FitGeometries, angleIronInTwo_isTwoBarsThatHug) {
  const TriangleMesh mesh = angleIron();
  const Fit one = fitGeometries({mesh}, upTo(1)).front();
  const Fit two = fitGeometries({mesh}, upTo(2)).front();
  expectProven(mesh, one);
  expectProven(mesh, two);
  ASSERT_EQ(two.shapes.size(), 2u);
  EXPECT_GT(one.overshoot.max, 0.05);   // the inner corner of the angle
  EXPECT_LT(two.overshoot.max, 0.005);  // two boxes hold two boxes
}

TEST(FitGeometries, firstCutOfAForkIsWorthNothing_theNextOnesAre) {
  const auto prong = [](double x) {
    return moved(boxMesh({0.02, 0.02, 0.15}), Vector3d::Zero(), {x, 0.0, 0.17});
  };
  const TriangleMesh fork = joined(boxMesh({0.12, 0.02, 0.02}), joined(prong(-0.1), prong(0.1)));
  const Fit fit = fitGeometries({fork}, upTo(4)).front();
  expectProven(fork, fit);
  EXPECT_LT(fit.overshoot.max, 0.015) << "0.08 in one shape";
}

TEST(FitGeometries, piecesInARow_haveAShapeEach) {
  const auto cube = [](double z) {
    return moved(boxMesh({0.05, 0.05, 0.05}), Vector3d::Zero(), {0.0, 0.0, z});
  };
  const TriangleMesh column = joined(cube(0.0), joined(cube(0.2), cube(0.41)));
  const Fit fit = fitGeometries({column}, upTo(4)).front();
  expectProven(column, fit);
  EXPECT_EQ(fit.shapes.size(), 3u);
  EXPECT_LT(fit.overshoot.max, 1e-3);
}

/// Two bars along x, two along y.
TriangleMesh barFrame() {
  const TriangleMesh along_x = joined(boxMeshAt({0.2, 0.015, 0.015}, {0.0, 0.135, 0.0}),
                                      boxMeshAt({0.2, 0.015, 0.015}, {0.0, -0.135, 0.0}));
  return joined(along_x, joined(boxMeshAt({0.015, 0.15, 0.015}, {0.185, 0.0, 0.0}),
                                boxMeshAt({0.015, 0.15, 0.015}, {-0.185, 0.0, 0.0})));
}

TEST(FitGeometries, frameOfFourBars_hasAShapeForEach) {
  const Fit fit = fitGeometries({barFrame()}, upTo(4)).front();
  expectProven(barFrame(), fit);
  EXPECT_EQ(fit.shapes.size(), 4u);
  EXPECT_LT(fit.overshoot.max, 0.015) << "0.12 in one shape";
}

TEST(FitGeometries, tableOnFourLegs_hasAShapeForEachAndForItsTop) {
  TriangleMesh table = boxMeshAt({0.3, 0.2, 0.015}, {0.0, 0.0, 0.3});
  for (const double x : {-0.28, 0.28}) {
    for (const double y : {-0.18, 0.18}) {
      table = joined(table, boxMeshAt({0.015, 0.015, 0.15}, {x, y, 0.15}));
    }
  }
  const Fit fit = fitGeometries({table}, upTo(8)).front();
  expectProven(table, fit);
  EXPECT_LE(fit.shapes.size(), 8u);
  EXPECT_LT(fit.overshoot.max, 0.02) << "0.19 in one shape";
}

TEST(FitGeometries, coarseGeometries_shareTheirShapes) {
  const auto fits = fitGeometries({barFrame(), barFrame()}, upTo(6));
  EXPECT_LE(fits[0].shapes.size() + fits[1].shapes.size(), 6u);
  for (const Fit& fit : fits) {
    expectProven(barFrame(), fit);
  }
}

TEST(FitGeometries, targetReached_noFurtherCuts) {
  const TriangleMesh mesh = angleIron();
  EXPECT_EQ(fitGeometries({mesh}, upTo(8, 0.01)).front().shapes.size(), 2u);
  EXPECT_EQ(fitGeometries({mesh}, upTo(8, 1.0)).front().shapes.size(), 1u);
}

TEST(FitGeometries, shapesAreSpentOnTheWorstGeometry) {
  const std::vector<Geometry> geometries{Box{{0.1, 0.1, 0.1}}, angleIron(), Sphere{0.2}};
  const auto fits = fitGeometries(geometries, upTo(4));
  ASSERT_EQ(fits.size(), 3u);
  EXPECT_EQ(fits[0].shapes.size(), 1u);
  EXPECT_EQ(fits[1].shapes.size(), 2u);
  EXPECT_EQ(fits[2].shapes.size(), 1u);
}

TEST(FitGeometries, fewerShapesThanGeometries_eachHasOneAllTheSame) {
  const auto fits = fitGeometries({angleIron(), angleIron(), angleIron()}, upTo(2));
  for (const auto& fit : fits) {
    EXPECT_EQ(fit.shapes.size(), 1u);
  }
  for (const Fit& fit : fitGeometries(std::vector<Geometry>(4, barFrame()), upTo(2))) {
    EXPECT_EQ(fit.shapes.size(), 1u);
  }
}

TEST(FitGeometries, noGeometry_noFits) { EXPECT_TRUE(fitGeometries({}, upTo(8)).empty()); }

TEST(FitGeometries, onlyCapsules_areCapsules) {
  FitLimits limits = upTo(4);
  limits.kinds = {false, true, false, false};
  for (const Geometry& geometry :
       {Geometry(angleIron()), Geometry(Box{{0.1, 0.2, 0.3}}), Geometry(Sphere{0.1}),
        Geometry(Capsule{0.1, 0.1}), Geometry(Cylinder{0.2, 0.1})}) {
    const Fit fit = fitGeometries({geometry}, limits).front();
    EXPECT_LE(provenExcess(geometry, fit), 0.0);
    for (const auto& enclosure : fit.shapes) {
      EXPECT_STREQ(kindName(enclosure.shape), "capsule");
    }
  }
}

TEST(FitGeometries, flatCylinder_isCutWhereItHelps) {
  const Cylinder cylinder{0.05, 0.2};
  const Fit one = fitGeometries({cylinder}, upTo(1)).front();
  const Fit four = fitGeometries({cylinder}, upTo(4)).front();
  expectProven(cylinder, four);
  EXPECT_LT(four.overshoot.max, one.overshoot.max);
}

TEST(FitGeometries, awkwardMeshes_areHeldByWhateverComesOut) {
  TriangleMesh inside_out = angleIron();
  for (auto& triangle : inside_out.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  TriangleMesh open = angleIron();
  open.triangles.resize(18);
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 1, 2}, {1, 2, 3}}};
  const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const TriangleMesh line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  const TriangleMesh point{{{1, 2, 3}}, {}};
  const TriangleMesh loose{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}};
  for (const auto& mesh : {inside_out, open, flat, triangle, line, point, loose}) {
    expectProven(mesh, fitGeometries({mesh}, upTo(5)).front());
  }
}

TEST(FitGeometries, scale_changesTheSizeAndNothingElse) {
  const Fit unit = fitGeometries({angleIron()}, upTo(3)).front();
  for (const double factor : {1e-6, 1e6}) {
    const TriangleMesh mesh = test::scaled(angleIron(), factor);
    const Fit fit = fitGeometries({mesh}, upTo(3)).front();
    EXPECT_LE(provenExcess(mesh, fit), 0.0);
    EXPECT_EQ(fit.shapes.size(), unit.shapes.size());
    EXPECT_NEAR(fit.overshoot.max / factor, unit.overshoot.max, 1e-3);
  }
}

TEST(FitGeometries, sameMesh_sameBytes) {
  const TriangleMesh mesh = prismMesh(0.1, 0.3, 20);
  const Fit first = fitGeometries({mesh}, upTo(4)).front();
  const Fit second = fitGeometries({mesh}, upTo(4)).front();
  ASSERT_EQ(first.shapes.size(), second.shapes.size());
  for (std::size_t i = 0; i < first.shapes.size(); ++i) {
    EXPECT_EQ(coreHalfExtents(first.shapes[i].shape), coreHalfExtents(second.shapes[i].shape));
    EXPECT_EQ(first.shapes[i].geometry_from_body.translation,
              second.shapes[i].geometry_from_body.translation);
  }
}

TEST(FitGeometries, limitsOutOfRange_areRefused) {
  EXPECT_THROW(fitGeometries({Sphere{0.1}}, upTo(0)), std::invalid_argument);
  EXPECT_THROW(fitGeometries({Sphere{0.1}}, upTo(1, -0.1)), std::invalid_argument);
  EXPECT_THROW(fitGeometries({Sphere{0.1}}, upTo(1, std::nan(""))), std::invalid_argument);
  FitLimits none;
  none.kinds = {false, false, false, false};
  EXPECT_THROW(fitGeometries({Sphere{0.1}}, none), std::invalid_argument);
}

TEST(ProvenExcess, shapeMadeSmaller_saysByHowMuch) {
  const TriangleMesh mesh = angleIron();
  Fit fit = fitGeometries({mesh}, upTo(2)).front();
  fit.shapes[0].shape = grown(fit.shapes[0].shape, -0.01);
  EXPECT_NEAR(provenExcess(mesh, fit), 0.01, 0.008);
  EXPECT_GT(provenExcess(mesh, fit), 0.0);
}

TEST(ProvenExcess, shapesSwapped_areNoEnclosure) {
  const TriangleMesh mesh = angleIron();
  const Fit sound = fitGeometries({mesh}, upTo(2)).front();
  Fit fit = sound;
  fit.shapes = {sound.shapes[1], sound.shapes[0]};
  EXPECT_GT(provenExcess(mesh, fit), 0.1);
}

TEST(ProvenExcess, partsOfOneShape_areHeldByThatShape) {
  const TriangleMesh mesh = angleIron();
  Fit fit = fitGeometries({mesh}, upTo(2)).front();
  const Enclosure whole = fitGeometries({mesh}, upTo(1)).front().shapes.front();
  if (fit.shape_of.empty()) {
    fit.shape_of = {0, 1};
  }
  EXPECT_LE(provenExcess(mesh, fit), 0.0);
  std::swap(fit.shape_of[0], fit.shape_of[1]);
  EXPECT_GT(provenExcess(mesh, fit), 0.1);
  fit.shapes.push_back(whole);
  std::fill(fit.shape_of.begin(), fit.shape_of.end(), 2);
  EXPECT_LE(provenExcess(mesh, fit), 0.0);
}

TEST(ProvenExcess, malformedFit_isInfinite) {
  const TriangleMesh mesh = angleIron();
  const Fit sound = fitGeometries({mesh}, upTo(2)).front();
  Fit fit = sound;
  fit.cuts.clear();
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity);
  fit = sound;
  fit.cuts[0].part = 7;
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity);
  fit = sound;
  fit.cuts[0].offset = std::nan("");
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity);
  fit = sound;
  fit.shape_of = {0, 2};
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity) << "there is no shape 2";
  fit.shape_of = {0, 1, 1};
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity) << "there is no third part";
  fit = sound;
  fit.shapes[1].geometry_from_body.rotation *= 2.0;
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity);
  fit = sound;
  fit.shapes[0].shape = Sphere{kInfinity};
  EXPECT_EQ(provenExcess(mesh, fit), kInfinity);
  EXPECT_EQ(provenExcess(mesh, Fit{}), kInfinity);
}

TEST(ProvenExcess, cutWhoseNormalIsNotUnit_isInfinite) {
  const TriangleMesh mesh = moved(angleIron(), Vector3d::Zero(), {10.0, 10.0, 10.0});
  Fit fit = fitGeometries({mesh}, upTo(2)).front();
  EXPECT_LE(provenExcess(mesh, fit), 0.0);
  fit.shapes[0].shape = fit.shapes[1].shape = Sphere{1e-6};
  // With the first, the height of every vertex is infinity less infinity.
  constexpr double kHuge = std::numeric_limits<double>::max();
  for (const Vector3d& normal :
       {Vector3d(kHuge, -kHuge, kHuge), Vector3d(1e200, 0.0, 0.0), Vector3d(0.0, 0.0, 0.0)}) {
    fit.cuts[0].normal = normal;
    EXPECT_EQ(provenExcess(mesh, fit), kInfinity) << normal.transpose();
  }
}

TEST(ProvenExcess, exactShape_needsNoRoom) {
  for (const Geometry& geometry :
       {Geometry(Sphere{0.1}), Geometry(Capsule{0.3, 0.1}), Geometry(Box{{0.1, 0.2, 0.3}})}) {
    EXPECT_EQ(provenExcess(geometry, fitGeometries({geometry}, upTo(1)).front()), 0.0);
  }
}

}  // namespace
}  // namespace collision_monitor
