// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

/// Memory of the searches for the distance of two convex cores. Its size is fixed, so no search
/// allocates.
namespace collision_monitor {

/// A point of the Minkowski difference B - A, and the points of A and B that it comes from.
struct SupportVertex {
  Eigen::Vector3d difference{Eigen::Vector3d::Zero()};  ///< on_b - on_a, in A's frame
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};        ///< in A's frame
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};        ///< in B's frame
};

/// What the last search of a pair found: points of A and B whose differences were nearest to the
/// origin, and the hull vertices where the last climbs ended. It may be stale, never wrong.
struct ConvexWarmStart {
  struct Ends {
    Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};  ///< in A's frame
    Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};  ///< in B's frame
  };

  /// For polytopes that overlap: a polytope inside their Minkowski difference that held the origin.
  struct CachedPolytope {
    static constexpr std::size_t kMaxCorners = 24;
    static constexpr std::size_t kMaxFaces = 2 * kMaxCorners - 4;
    using Face = std::array<std::uint8_t, 3>;  ///< corners, counter-clockwise seen from outside

    std::array<Ends, kMaxCorners> corners;
    std::array<Face, kMaxFaces> faces;
  };

  std::uint32_t size{0};
  std::uint32_t vertex_of_a{0};  ///< of a hull; 0 for other cores
  std::uint32_t vertex_of_b{0};
  std::uint8_t polytope_corners{0};  ///< number of corners of `polytope`
  std::uint8_t polytope_faces{0};    ///< 0: there is no `polytope`
  std::array<Ends, 4> ends;
  CachedPolytope polytope;
};

/// Empties a warm start, so that another pair can use it.
inline void forget(ConvexWarmStart& warm) noexcept {
  warm.size = 0;
  warm.vertex_of_a = 0;
  warm.vertex_of_b = 0;
  warm.polytope_faces = 0;
}

/// EPA's polytope. It lies inside the Minkowski difference B - A and grows until one of its faces
/// is a face of the difference.
struct ConvexWorkspace {
  static constexpr std::size_t kMaxVertices = 512;
  static constexpr std::size_t kMaxFaces = 2 * kMaxVertices;

  struct Face {
    Eigen::Vector3d normal;  ///< unit, outward
    double offset;           ///< normal . x of the face's plane
    std::array<std::uint16_t, 3> corners;
    std::array<std::uint16_t, 3> neighbours;  ///< across the edge from corner k to corner k + 1
    bool is_visible;
    bool is_gone;
  };

  std::array<SupportVertex, kMaxVertices> vertices;
  std::array<Face, kMaxFaces> faces;
  std::array<double, kMaxFaces> keys;  ///< depth bound by face; infinity: none, or gone
  std::size_t vertex_count{0};
  std::size_t face_count{0};
  std::array<std::uint16_t, kMaxFaces> free_faces;
  std::size_t free_count{0};
  std::array<std::uint16_t, kMaxFaces> visible;  ///< faces that see the new vertex; also a stack
  std::array<std::uint16_t, kMaxVertices> face_from;  ///< by vertex: the new face that starts there
};

}  // namespace collision_monitor
