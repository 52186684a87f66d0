// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/narrow_phase/convex_distance.h"

/// Cases of other libraries' test suites, from the folder peer_cases of the shared data.
namespace collision_monitor::test {

/// What a peer's test asserts of a pair. Nothing where it does not.
struct PeerExpectation {
  std::optional<double> distance;
  std::optional<double> unsigned_distance;  ///< 0 where they overlap
  std::optional<bool> collide;              ///< distance <= margin
  double margin{0.0};
  double tolerance{0.0};
};

struct PeerGeometry {
  ConvexGeometry geometry;
  Pose world_from_body;
};

struct PeerCase {
  std::string id;
  PeerGeometry a;
  PeerGeometry b;
  PeerExpectation expect;
};

/// Every pair of convex geometries, listed or given by formula. Nothing without shared data.
std::optional<std::vector<PeerCase>> convexPeerCases();

/// Two meshes that a peer once failed on; it asserts only that an answer comes back.
struct PeerMeshCase {
  std::string id;
  Pose world_from_b;
};

/// The small sphere (A, where the world is) and the large one, and where it is put.
struct PeerSpheres {
  TriangleMesh a;
  TriangleMesh b;
  std::vector<PeerMeshCase> cases;
};
std::optional<PeerSpheres> sphereMeshPeerCases();

/// What the peer asserts and an answer does not fulfil; empty when all is well.
/// @param slack [m] beyond the peer's own tolerance.
std::string differenceFrom(const PeerExpectation& expect, double distance, double slack);

}  // namespace collision_monitor::test
