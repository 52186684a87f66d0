// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/narrow_phase/convex_distance.h"

/// Cases from the test suites of other libraries, in the folder peer_cases of the shared data.
namespace collision_monitor::test {

/// What a peer's test asserts of a pair; empty members are not asserted.
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

/// Every pair of convex geometries, listed or given by formula. None without shared data.
std::optional<std::vector<PeerCase>> convexPeerCases();

/// Two meshes on which a peer once failed. It only asserts that an answer comes back.
struct PeerMeshCase {
  std::string id;
  Pose world_from_b;
};

/// The small sphere (A, in the world frame), the large one, and its poses.
struct PeerSpheres {
  TriangleMesh a;
  TriangleMesh b;
  std::vector<PeerMeshCase> cases;
};
std::optional<PeerSpheres> sphereMeshPeerCases();

/// The assertions of the peer that an answer does not fulfil; empty if it fulfils all.
/// @param slack [m] beyond the peer's own tolerance.
std::string differenceFrom(const PeerExpectation& expect, double distance, double slack);

}  // namespace collision_monitor::test
