// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/peer_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <type_traits>

#include "geometry/hulls/convex_hull.h"
#include "model/mesh_files/mesh_reader.h"
#include "narrow_phase/geometry_distance.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "narrow_phase/mesh_depth/mesh_way_out.h"
#include "support/mesh_overlap.h"
#include "support/reference/convex_measure.h"
#include "support/reference/convex_reference.h"
#include "support/reference/reference_distance.h"
#include "support/robots/file_loader.h"
#include "support/sample_meshes.h"
#include "support_fcl/fcl_mesh.h"

// Where an expectation and this package differ, the slow references decide; such cases are printed
// and named in docs/accuracy.md.
namespace collision_monitor::test {
namespace {

/// Nothing for geometries that are not of the family of shapes.
std::optional<Shape> shapeOf(const ConvexGeometry& geometry) {
  const auto take = [](const auto& held) -> std::optional<Shape> {
    if constexpr (std::is_convertible_v<decltype(held), Shape>) {
      return Shape(held);
    } else {
      return std::nullopt;
    }
  };
  return std::visit(take, geometry);
}

struct Truth {
  double distance;
  double error;  // of the reference and what this package promises, of the lengths
};

Truth truthOf(const PeerCase& peer, double found) {
  const auto a = shapeOf(peer.a.geometry);
  const auto b = shapeOf(peer.b.geometry);
  if (a && b) {
    return {referenceDistance(*a, peer.a.world_from_body, *b, peer.b.world_from_body).distance,
            1e-13};
  }
  long double distance = static_cast<long double>(found);
  convexReference(
      {&peer.a.geometry, peer.a.world_from_body, &peer.b.geometry, peer.b.world_from_body},
      distance);
  return {static_cast<double>(distance), 1e-6};
}

double lengthsOf(const PeerCase& peer) {
  const double apart =
      (peer.a.world_from_body.translation - peer.b.world_from_body.translation).norm();
  return std::max(1.0, extentOf(peer.a.geometry) + extentOf(peer.b.geometry) + apart);
}

ConvexDistance measure(const PeerCase& peer) {
  return measureCold(peer.a.geometry, peer.a.world_from_body, peer.b.geometry,
                     peer.b.world_from_body);
}

TEST(PeerCases, everyConvexPair_isDecidedByTheReference) {
  const auto cases = convexPeerCases();
  if (!cases) {
    GTEST_SKIP() << kNoSharedData;
  }
  int differences = 0;
  double worst = 0.0;
  for (const PeerCase& peer : *cases) {
    SCOPED_TRACE(peer.id);
    const ConvexDistance found = measure(peer);
    const double distance = found.measured.distance;
    const double lengths = lengthsOf(peer);
    EXPECT_EQ(found.quality, Quality::exact);
    const Truth truth = truthOf(peer, distance);
    const double error = std::abs(distance - truth.distance) / lengths;
    EXPECT_LE(error, truth.error);
    worst = std::max(worst, error);
    const PosedConvexPair pair{&peer.a.geometry, peer.a.world_from_body, &peer.b.geometry,
                               peer.b.world_from_body};
    EXPECT_NEAR(distance, certify(pair, found.measured).gap_along_normal, 1e-9 * lengths);
    const std::string differs =
        differenceFrom(peer.expect, distance, 1e-7 * (1.0 + std::abs(distance)));
    if (!differs.empty()) {
      ++differences;
      std::printf("| %s | %s | %.9g | %.9g |\n", peer.id.c_str(), differs.c_str(), distance,
                  truth.distance);
    }
  }
  std::printf("%zu cases, worst error %.1e of the lengths, %d expectations not met\n",
              cases->size(), worst, differences);
  EXPECT_EQ(differences, 0);
}

/// The surface of what has flat faces. A mesh reaches to 1e6 m, which some cases exceed.
std::optional<MeshTree> meshOf(const ConvexGeometry& geometry) {
  const auto* hull = std::get_if<ConvexHull>(&geometry);
  if (hull != nullptr && !hull->faces().empty() && hull->boundingRadius() < 1e6) {
    return MeshTree(convexHullOf(hull->vertices()), hull->hasVolume());
  }
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return MeshTree(boxMesh(box->half_extents), box->half_extents.minCoeff() > 0.0);
  }
  return std::nullopt;
}

// Triangles, hulls and boxes once more, as meshes against meshes and against the rest.
TEST(PeerCases, flatFacesAsMeshes_sayTheSame) {
  const auto cases = convexPeerCases();
  if (!cases) {
    GTEST_SKIP() << kNoSharedData;
  }
  const auto workspace = std::make_unique<ConvexWorkspace>();
  const auto memory = std::make_unique<MeshQueryMemory>();
  int count = 0;
  double worst = 0.0;
  for (const PeerCase& peer : *cases) {
    const auto mesh_a = meshOf(peer.a.geometry);
    const auto mesh_b = meshOf(peer.b.geometry);
    if (!mesh_a && !mesh_b) {
      continue;
    }
    SCOPED_TRACE(peer.id);
    ConvexWarmStart warm;
    ConvexSearch convex{*workspace, warm};
    GeometrySearch search{convex, *memory};
    const GeometryRef a = mesh_a ? GeometryRef(&*mesh_a) : GeometryRef(&peer.a.geometry);
    const GeometryRef b = mesh_b ? GeometryRef(&*mesh_b) : GeometryRef(&peer.b.geometry);
    const double found =
        signedDistanceBetween(a, peer.a.world_from_body, b, peer.b.world_from_body, search)
            .measured.distance;
    const double truth = measure(peer).measured.distance;
    const double error = std::abs(std::max(found, 0.0) - std::max(truth, 0.0)) / lengthsOf(peer);
    EXPECT_LE(error, 1e-9) << "as convex geometries " << truth << ", as meshes " << found;
    worst = std::max(worst, error);
    ++count;
  }
  std::printf("%d cases as meshes, worst difference %.1e of the lengths\n", count, worst);
  EXPECT_GT(count, 0);
}

// The small sphere touches the large one from inside.
TEST(PeerCases, sphereMeshesInEachOther_overlapAndDoNotThrow) {
  const auto spheres = sphereMeshPeerCases();
  if (!spheres) {
    GTEST_SKIP() << kNoSharedData;
  }
  const MeshTree a(spheres->a, true);
  const MeshTree b(spheres->b, true);
  const auto memory = std::make_unique<MeshQueryMemory>();
  for (const PeerMeshCase& peer : spheres->cases) {
    SCOPED_TRACE(peer.id);
    const Pose world_from_a;
    const PlacedMesh small{a, world_from_a};
    const PlacedMesh large{b, peer.world_from_b};
    EXPECT_TRUE(meshesOverlap(small, large, *memory));
    EXPECT_EQ(distanceBetween(small, large, *memory).state, MeshState::overlapping);
    EXPECT_EQ(distanceBetween(large, small, *memory).state, MeshState::overlapping);
    KeptDepth nothing;
    const MeshDepth deep = depthOf(small, large, *memory, nothing, 4000);
    const WayOut out = wayOut(small, large, deep.deepest.normal_a_to_b);
    EXPECT_LE(-deep.deepest.distance, out.length);
    EXPECT_NEAR(out.length, 2.0, 0.05);  // one radius in, and out over its own two
  }
  EXPECT_EQ(spheres->cases.size(), 48U);
}

// Its partner rob.obj is not among the data: the room with a copy of itself, placed as FCL does.
TEST(PeerCases, roomOfFcl_agreesWithFcl) {
  const auto shared = sharedDataDir();
  if (!shared || !std::filesystem::exists(*shared / "meshes_misc/fcl/env.obj")) {
    GTEST_SKIP() << kNoSharedData;
  }
  const TriangleMesh mesh = readMesh(readFile(*shared / "meshes_misc/fcl/env.obj"), "env.obj");
  const MeshTree tree(mesh);
  const auto fcl = toFcl(mesh);
  const auto memory = std::make_unique<MeshQueryMemory>();
  Random random(20260101);
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Pose a = randomPose(random, 0.0);
    Pose b = randomPose(random, 0.0);
    b.translation = {uniform(random, -3000, 3000), uniform(random, -3000, 3000),
                     uniform(random, 0, 3000)};
    const double truth = std::max(0.0, fclMeshDistance(fclObject(fcl, a), fclObject(fcl, b)));
    const double found = distanceBetween({tree, a}, {tree, b}, *memory).measured.distance;
    ASSERT_NEAR(found, truth, 1e-9 * 3000.0) << i;
    worst = std::max(worst, std::abs(found - truth));
  }
  std::printf("60 poses, worst difference %.1e over lengths of 3000\n", worst);
}

}  // namespace
}  // namespace collision_monitor::test
