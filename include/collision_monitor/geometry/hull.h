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

/// a . b, component by component. A vector product would load numbers in pairs, and the processor
/// would stall where they were just written one by one.
inline double along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// The convex hull of points as a solid: its vertices, its faces, its edges and their graph.
///
/// Built once; queries neither allocate nor throw and may run at the same time.
/// Frames: that of the points. Units: metres.
/// Limits: a flat hull is legal and has two opposite faces. So are collinear and coincident points,
/// which have no faces; see convexHullOf.
class ConvexHull {
 public:
  /// The solid lies where normal . x <= offset; so does every vertex, in floating point too.
  struct Face {
    Eigen::Vector3d normal;  ///< unit, outward
    double offset;           ///< [m] of the face's plane along the normal
  };

  /// An edge between two faces that are not in one plane.
  struct Edge {
    std::uint32_t from;   ///< vertex
    std::uint32_t to;     ///< vertex
    std::uint32_t left;   ///< the face on this side, seen from outside along the edge
    std::uint32_t right;  ///< the other face
  };

  /// Indices of vertices or faces, stored in the hull.
  struct Indices {
    const std::uint32_t* first;  ///< the first one
    const std::uint32_t* last;   ///< beyond the last one

    const std::uint32_t* begin() const noexcept { return first; }  ///< for loops over the indices
    const std::uint32_t* end() const noexcept { return last; }     ///< behind the last one
    /// How many indices there are.
    std::size_t size() const noexcept { return static_cast<std::size_t>(last - first); }
  };

  /// Neighbours of a vertex that a climb tests together, one column per coordinate.
  struct Fan {
    static constexpr int kSize = 8;  ///< how many neighbours a fan holds

    Eigen::Array<double, kSize, 1> x;         ///< [m] of each neighbour
    Eigen::Array<double, kSize, 1> y;         ///< [m] likewise
    Eigen::Array<double, kSize, 1> z;         ///< [m] likewise
    std::array<std::uint32_t, kSize> vertex;  ///< the first one repeats where there are fewer

    /// `direction` . x of each.
    Eigen::Array<double, kSize, 1> reaches(const Eigen::Vector3d& direction) const noexcept {
      return direction.x() * x + direction.y() * y + direction.z() * z;
    }
  };

  /// A vertex that is farthest in a direction.
  struct Extreme {
    std::uint32_t vertex;  ///< index of the vertex
    double reach;          ///< direction . x of the vertex
    double beside;         ///< the greatest direction . x in its fans; -infinity without fans
  };

  /// The fans of one vertex, stored in the hull.
  struct Fans {
    const Fan* first;  ///< the first one
    const Fan* last;   ///< beyond the last one

    const Fan* begin() const noexcept { return first; }  ///< for loops over the fans
    const Fan* end() const noexcept { return last; }     ///< behind the last one
  };

  /// @throws std::invalid_argument when there is no point or one is not finite.
  explicit ConvexHull(const std::vector<Eigen::Vector3d>& points);

  /// [m] Corners of the hull.
  const std::vector<Eigen::Vector3d>& vertices() const noexcept { return vertices_; }
  /// Both sides of a flat hull; none of collinear and coincident points.
  const std::vector<Face>& faces() const noexcept { return faces_; }
  /// All edges of the hull, or none where slivers tear or fold its faces.
  const std::vector<Edge>& edges() const noexcept { return edges_; }
  /// False for flat hulls, and for points on a line.
  bool hasVolume() const noexcept { return has_volume_; }

  /// The corners of a face in order, counter-clockwise seen from outside.
  Indices ringOf(std::uint32_t face) const noexcept {
    return {ring_corners_.data() + first_corner_[face],
            ring_corners_.data() + first_corner_[face + 1]};
  }
  /// The faces that meet at a vertex.
  Indices facesAt(std::uint32_t vertex) const noexcept {
    return {faces_at_.data() + first_face_at_[vertex],
            faces_at_.data() + first_face_at_[vertex + 1]};
  }
  /// The neighbours of a vertex: along its edges, along the diagonals that divide its faces, and
  /// those of vertices that nearly coincide with it. Empty if !canClimb().
  Fans fansOf(std::uint32_t vertex) const noexcept {
    return {fans_.data() + first_fan_[vertex], fans_.data() + first_fan_[vertex + 1]};
  }

  /// The radius of a ball about the origin of the frame that holds the hull.
  double boundingRadius() const noexcept { return bounding_radius_; }

  /// Whether climbing finds the farthest vertex: a vertex with no farther one in its fans is the
  /// farthest, up to rounding. False for hulls without triangles.
  bool canClimb() const noexcept { return !fans_.empty(); }

  /// The greatest `direction` . x in the fans of `vertex`; -infinity without fans.
  double reachBeside(const Eigen::Vector3d& direction, std::uint32_t vertex) const noexcept {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Fan& fan : fansOf(vertex)) {
      const double reach = fan.reaches(direction).maxCoeff();
      farthest = reach > farthest ? reach : farthest;
    }
    return farthest;
  }

  /// Index of a vertex that is farthest in `direction` (need not be unit). The search starts at
  /// `start`; the last answer for a similar direction makes the climb short. A large hull also
  /// looks up a start in a map of directions, and uses it if it is farther.
  ///
  /// Error: large hulls climb from neighbour to neighbour. Rounding may stop that short of the
  /// farthest vertex by about 1e-10 of the hull's extent. Small hulls test every vertex.
  /// Source: climbing: Gilbert, Foo, "Computing the distance between general convex objects in
  /// three-dimensional space" (1990), and Cameron, "Enhancing GJK" (1997); table of directions:
  /// Ehmann, Lin, "Accelerated proximity queries between convex polyhedra by multi-level Voronoi
  /// marching" (2000).
  /// @pre `start` names a vertex.
  std::uint32_t supportVertex(const Eigen::Vector3d& direction,
                              std::uint32_t start) const noexcept {
    return climbs_ ? climb(direction, start).vertex : lookAtAll(direction);
  }

  /// A vertex that is farthest in `direction`, and its reach. `start` is as in supportVertex, and
  /// is preferred among equally far vertices.
  /// Error: as supportVertex of large hulls; this climbs in small hulls too.
  Extreme extreme(const Eigen::Vector3d& direction, std::uint32_t start) const noexcept {
    if (canClimb()) {
      return climb(direction, start);
    }
    const std::uint32_t farthest = lookAtAll(direction);
    return {farthest, along(direction, vertices_[farthest]),
            -std::numeric_limits<double>::infinity()};
  }

 private:
  // A vertex, and the vertex of its fans to go on to: itself where none is farther.
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

  // Every search reads the following members, so they stand together.
  double bounding_radius_{0.0};
  std::vector<Eigen::Vector3d> vertices_;
  // The fans of vertex i are fans_[first_fan_[i]] up to the first one of the next vertex.
  std::vector<std::uint32_t> first_fan_;
  std::vector<Fan> fans_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  // The corners of face i start at ring_corners_[first_corner_[i]].
  std::vector<std::uint32_t> first_corner_;
  std::vector<std::uint32_t> ring_corners_;
  // The faces at vertex i start at faces_at_[first_face_at_[i]].
  std::vector<std::uint32_t> first_face_at_;
  std::vector<std::uint32_t> faces_at_;
  // A cube of directions, each side divided into rows_ by rows_ cells. By cell: where a climb along
  // the cell's middle ends. Empty where climbs are short.
  std::vector<std::uint32_t> farthest_;
  std::size_t rows_{0};
  bool has_volume_{false};
  bool climbs_{false};
};

}  // namespace collision_monitor
