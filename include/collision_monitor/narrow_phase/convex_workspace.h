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
  /// Two points, one of each side.
  struct Ends {
    Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};  ///< in A's frame
    Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};  ///< in B's frame
  };

  /// For polytopes that overlap: a polytope inside their Minkowski difference that held the origin.
  struct CachedPolytope {
    /// Corners of a polytope that is worth keeping.
    static constexpr std::size_t kMaxCorners = 24;
    /// Triangles of a closed polytope with so many corners.
    static constexpr std::size_t kMaxFaces = 2 * kMaxCorners - 4;
    using Face = std::array<std::uint8_t, 3>;  ///< corners, counter-clockwise seen from outside

    std::array<Ends, kMaxCorners> corners;  ///< the first polytope_corners are used
    std::array<Face, kMaxFaces> faces;      ///< the first polytope_faces are used
  };

  std::uint32_t size{0};             ///< how many of `ends` are used; 0: nothing is known
  std::uint32_t vertex_of_a{0};      ///< of a hull; 0 for other cores
  std::uint32_t vertex_of_b{0};      ///< likewise
  std::uint8_t polytope_corners{0};  ///< number of corners of `polytope`
  std::uint8_t polytope_faces{0};    ///< 0: there is no `polytope`
  std::array<Ends, 4> ends;          ///< whose differences were nearest to the origin
  CachedPolytope polytope;           ///< of the last depth; may be absent
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
  static constexpr std::size_t kMaxVertices = 512;  ///< where a search gives up
  /// Triangles of a closed polytope with so many vertices.
  static constexpr std::size_t kMaxFaces = 2 * kMaxVertices;

  /// A triangle of the polytope.
  struct Face {
    Eigen::Vector3d normal;                   ///< unit, outward
    double offset;                            ///< normal . x of the face's plane
    std::array<std::uint16_t, 3> corners;     ///< vertices, counter-clockwise seen from outside
    std::array<std::uint16_t, 3> neighbours;  ///< across the edge from corner k to corner k + 1
    bool is_visible;                          ///< it sees the vertex that is being added
    bool is_gone;                             ///< its place may be used again
  };

  std::array<SupportVertex, kMaxVertices> vertices;  ///< the first vertex_count are used
  std::array<Face, kMaxFaces> faces;                 ///< the first face_count are used or gone
  std::array<double, kMaxFaces> keys;  ///< depth bound by face; infinity: none, or gone
  std::size_t vertex_count{0};         ///< how many of `vertices` are used
  std::size_t face_count{0};           ///< how many places of `faces` were ever used
  std::array<std::uint16_t, kMaxFaces> free_faces;  ///< places of faces that are gone
  std::size_t free_count{0};                        ///< how many of `free_faces` are used
  std::array<std::uint16_t, kMaxFaces> visible;     ///< faces that see the new vertex; also a stack
  std::array<std::uint16_t, kMaxVertices> face_from;  ///< by vertex: the new face that starts there
};

}  // namespace collision_monitor
