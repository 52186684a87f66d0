// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// a . b, number by number: a product of vectors reads numbers in pairs, and processors wait where
/// these were just written one by one.
inline double along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// The convex hull of points as a solid: its corners, its faces, its edges and the graph they make.
///
/// Built once; queries neither allocate nor throw and may run at the same time.
/// Frames: that of the points. Units: metres.
/// Limits: flat hulls are legal and have two opposite faces, collinear and coincident points too
/// and have none; see convexHullOf.
class ConvexHull {
 public:
  /// The solid lies where normal . x <= offset; every vertex does, in floating point too.
  struct Face {
    Eigen::Vector3d normal;  ///< unit, outward
    double offset;
  };

  /// Between two faces that are not in one plane.
  struct Edge {
    std::uint32_t from, to;     ///< vertices
    std::uint32_t left, right;  ///< faces, seen from outside along the edge
  };

  /// Numbers of vertices, as the hull keeps them.
  struct Indices {
    const std::uint32_t* first;
    const std::uint32_t* last;  ///< beyond the last one

    const std::uint32_t* begin() const noexcept { return first; }
    const std::uint32_t* end() const noexcept { return last; }
    std::size_t size() const noexcept { return static_cast<std::size_t>(last - first); }
  };

  /// Vertices that a climb looks at together, in columns.
  struct Fan {
    static constexpr int kSize = 8;

    Eigen::Array<double, kSize, 1> x, y, z;
    std::array<std::uint32_t, kSize> vertex;  ///< where there are fewer, again the first

    /// `direction` . x of each.
    Eigen::Array<double, kSize, 1> reaches(const Eigen::Vector3d& direction) const noexcept {
      return direction.x() * x + direction.y() * y + direction.z() * z;
    }
  };

  /// A vertex that is farthest in a direction.
  struct Extreme {
    std::uint32_t vertex;
    double reach;   ///< direction . x of it
    double beside;  ///< the greatest of its fans' vertices; -infinity without any
  };

  struct Fans {
    const Fan* first;
    const Fan* last;  ///< beyond the last one

    const Fan* begin() const noexcept { return first; }
    const Fan* end() const noexcept { return last; }
  };

  /// @throws std::invalid_argument when there is no point or one is not finite.
  explicit ConvexHull(const std::vector<Eigen::Vector3d>& points);

  const std::vector<Eigen::Vector3d>& vertices() const noexcept { return vertices_; }
  const std::vector<Face>& faces() const noexcept { return faces_; }
  /// All of a flat hull's and a solid's, or none: of faces that slivers tear or fold.
  const std::vector<Edge>& edges() const noexcept { return edges_; }
  bool hasVolume() const noexcept { return has_volume_; }

  /// The corners of a face one after another, counter-clockwise seen from outside.
  Indices ringOf(std::uint32_t face) const noexcept {
    return {ring_corners_.data() + first_corner_[face],
            ring_corners_.data() + first_corner_[face + 1]};
  }
  /// The faces that have a vertex for a corner.
  Indices facesAt(std::uint32_t vertex) const noexcept {
    return {faces_at_.data() + first_face_at_[vertex],
            faces_at_.data() + first_face_at_[vertex + 1]};
  }
  /// The other ends of a vertex's edges, of diagonals that divide its faces, and of those of
  /// vertices all but coincident with it. None if !canClimb().
  Fans fansOf(std::uint32_t vertex) const noexcept {
    return {fans_.data() + first_fan_[vertex], fans_.data() + first_fan_[vertex + 1]};
  }

  /// Radius about the origin of the frame that holds the hull.
  double boundingRadius() const noexcept { return bounding_radius_; }

  /// Whether a vertex none of whose fans' vertices is farther in some direction is the farthest
  /// there, but for rounding. False of hulls without triangles.
  bool canClimb() const noexcept { return !fans_.empty(); }

  /// The greatest `direction` . x among the vertices of `vertex`'s fans; -infinity without any.
  double reachBeside(const Eigen::Vector3d& direction, std::uint32_t vertex) const noexcept {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Fan& fan : fansOf(vertex)) {
      const double reach = fan.reaches(direction).maxCoeff();
      farthest = reach > farthest ? reach : farthest;
    }
    return farthest;
  }

  /// Index of a vertex that is farthest in `direction` (need not be unit). `start` is a vertex
  /// to begin at; the last answer for a similar direction makes the climb short. Of large
  /// hulls a map of directions knows another, which is taken where it is farther.
  ///
  /// Error: large hulls climb from neighbour to neighbour, which rounding may stop short of the
  /// farthest vertex by about 1e-10 of the hull's extent; small hulls look at every vertex.
  /// Source: Gilbert, Foo, "Computing the distance between general convex objects in
  /// three-dimensional space" (1990), and Cameron, "Enhancing GJK" (1997), for climbing; Ehmann,
  /// Lin, "Accelerated proximity queries between convex polyhedra by multi-level Voronoi marching"
  /// (2000), for starting from a table of directions.
  /// @pre `start` names a vertex.
  std::uint32_t supportVertex(const Eigen::Vector3d& direction,
                              std::uint32_t start) const noexcept {
    return climbs_ ? climb(direction, start).vertex : lookAtAll(direction);
  }

  /// A vertex that is farthest in `direction`, and by how much; `start` as in supportVertex. Of
  /// vertices that are, `start` itself is preferred.
  /// Error: climbs in small hulls too, see supportVertex.
  Extreme extreme(const Eigen::Vector3d& direction, std::uint32_t start) const noexcept {
    if (canClimb()) {
      return climb(direction, start);
    }
    const std::uint32_t farthest = lookAtAll(direction);
    return {farthest, along(direction, vertices_[farthest]),
            -std::numeric_limits<double>::infinity()};
  }

 private:
  // A vertex, and the one of its fans to go on to; itself where none is farther.
  struct Look {
    Extreme here;
    std::uint32_t next;
  };

  void addRings(const std::vector<std::vector<std::uint32_t>>& rings);
  void addFans(const std::vector<std::vector<std::uint32_t>>& neighbours);
  void mapDirections();
  std::size_t cellOf(const Eigen::Vector3d& direction) const noexcept;
  Look lookAround(const Eigen::Vector3d& direction, std::uint32_t from) const noexcept;
  Extreme climb(const Eigen::Vector3d& direction, std::uint32_t start) const noexcept;
  std::uint32_t lookAtAll(const Eigen::Vector3d& direction) const noexcept;

  // What every search reads stands together.
  double bounding_radius_{0.0};
  std::vector<Eigen::Vector3d> vertices_;
  // Those of vertex i are fans_[first_fan_[i]] up to the next one's first.
  std::vector<std::uint32_t> first_fan_;
  std::vector<Fan> fans_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  // Those of face i are ring_corners_[first_corner_[i]] up to the next one's first.
  std::vector<std::uint32_t> first_corner_;
  std::vector<std::uint32_t> ring_corners_;
  // Those at vertex i are faces_at_[first_face_at_[i]] up to the next one's first.
  std::vector<std::uint32_t> first_face_at_;
  std::vector<std::uint32_t> faces_at_;
  // By cell of a cube about all directions, each side of which has rows_ by rows_ cells: where the
  // climb along the middle of the cell ends. Empty where climbs are short.
  std::vector<std::uint32_t> farthest_;
  std::size_t rows_{0};
  bool has_volume_{false};
  bool climbs_{false};
};

}  // namespace collision_monitor
