// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/part_corners.h"
#include "collision_monitor/geometry/surface_rim.h"
#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/geometry/winding.h"

namespace collision_monitor {

/// Eight children side by side, so that one instruction tests several of them.
///
/// Each child is bounded by an axis-aligned box and by a slab across the mean normal of its
/// triangles. A patch of surface is thin along its normal, which an axis-aligned box cannot use.
/// Both enclose the triangles in exact arithmetic. The normal is at most of unit length, so a gap
/// measured along it is never too large.
///
/// Frames: the mesh's axes, origin at MeshTree::center(). Units: metres.
struct alignas(64) MeshTreeNode {
  static constexpr std::uint32_t kWidth = 8;               ///< children of a node
  static constexpr std::uint32_t kTriangle = 0x80000000u;  ///< marks a child that is a triangle

  float center[3][kWidth];      ///< by axis and child: the middle of the box
  float half[3][kWidth];        ///< by axis and child: half its extent, >= 0
  float normal[3][kWidth];      ///< by axis and child: mean normal of the triangles
  float slab_center[kWidth];    ///< by child: the middle of the slab, along the normal
  float slab_half[kWidth];      ///< by child: half its thickness, >= 0
  std::uint32_t child[kWidth];  ///< a node, or kTriangle + a triangle, or kNone
};

/// What winding numbers need to tell the inside of a surface that is not closed.
struct OpenSurface {
  /// Where the surface ends. Empty if that is long: then the next three are there instead.
  SurfaceRim rim;
  std::vector<WindingMoments> moments;  ///< by node: the moments of all triangles below it
  /// By triangle, in the order of the tree: the sides at which the surface ends, see rimSidesOf.
  std::vector<std::uint8_t> rim_sides;
  /// [m] By node: the length of all such sides below it, rounded up.
  std::vector<float> rim_lengths;
  /// The faces of its convex hull, if they are known. Nothing beyond one is inside, even if several
  /// layers of the surface cover more than half of all directions there.
  std::vector<ConvexHull::Face> hull;
  /// [m] The radius of a ball about the tree's center within the hull; infinity: no hull is known.
  double hull_ball{std::numeric_limits<double>::infinity()};
};

/// A static hierarchy over the triangles of a mesh for queries against other meshes and shapes.
///
/// Node 0 has the whole mesh as its only child. So every bound stands in some node, and the two
/// numbers (node, slot) name it. Queries neither allocate nor throw and may run at the same time.
/// Frames: triangles in the mesh's frame. Units: metres.
/// Source: wide nodes: Wald, Benthin, Boulos, "Getting Rid of Packets" (2008); binned surface area
/// heuristic: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007); slabs:
/// Kay, Kajiya, "Ray Tracing Complex Scenes" (1986), with one direction chosen for each child.
class MeshTree {
 public:
  /// The most levels below node 0. From level kSplitByCount on, ranges are halved at any cost.
  static constexpr std::uint32_t kSplitByCount = 24;
  /// Upper bound of the tree's depth.
  static constexpr std::uint32_t kMaxLevels = kSplitByCount + 32;

  /// A mesh without triangles is treated as its vertices.
  /// @param is_closed the triangles bound a solid, in whichever direction they turn, so the mesh
  /// has an inside. Not checked here.
  /// @throws std::invalid_argument when the mesh has no vertices, a vertex is not finite or beyond
  /// 1e6 m, or a triangle has a missing vertex.
  explicit MeshTree(const TriangleMesh& mesh, bool is_closed = false);

  /// A tree of a surface that need not be closed: winding numbers tell its inside. Takes about a
  /// quarter more memory if its rim is long.
  /// @param oriented the result of orientedSurface.
  /// @throws std::invalid_argument as the constructor.
  static MeshTree ofOriented(const TriangleMesh& oriented);

  /// Node 0 is the root.
  const std::vector<MeshTreeNode>& nodes() const noexcept { return nodes_; }
  /// In the order of the tree.
  const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
  /// By position in triangles(): the number of the triangle (or vertex) in the mesh.
  const std::vector<std::uint32_t>& sourceTriangles() const noexcept { return source_triangles_; }
  /// The corners of what nodes hold.
  const PartCorners& partCorners() const noexcept { return part_corners_; }
  /// [m] The origin of the nodes' frame, in the frame of the mesh.
  const Eigen::Vector3d& center() const noexcept { return center_; }
  /// [m] The radius of a ball about center() that holds all triangles.
  double radius() const noexcept { return radius_; }
  /// Whether the triangles bound a solid, as the constructor was told.
  bool isClosed() const noexcept { return is_closed_; }
  /// None if the mesh is closed or has no inside.
  const std::optional<OpenSurface>& openSurface() const noexcept { return open_; }
  /// Tells an open surface its convex hull, with volume.
  void setHull(const std::vector<ConvexHull::Face>& hull);
  /// Whether points can be inside: of a solid, or of a surface with winding numbers.
  bool hasInside() const noexcept { return is_closed_ || open_; }
  /// One corner of each connected piece of the surface. A piece that crosses no other surface lies
  /// inside or outside a solid with all its points.
  const std::vector<Eigen::Vector3d>& pieces() const noexcept { return pieces_; }
  /// The pieces, and the corners that are farthest along each axis and each diagonal of the frame.
  /// A mesh that enters an open surface through a hole does so with one of these points.
  const std::vector<Eigen::Vector3d>& probes() const noexcept { return probes_; }

 private:
  MeshTree(const TriangleMesh& mesh, bool is_closed, bool is_open);

  std::vector<MeshTreeNode> nodes_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> source_triangles_;
  PartCorners part_corners_;
  std::vector<Eigen::Vector3d> pieces_;
  std::vector<Eigen::Vector3d> probes_;
  std::optional<OpenSurface> open_;
  Eigen::Vector3d center_{Eigen::Vector3d::Zero()};
  double radius_{0.0};
  bool is_closed_{false};
};

}  // namespace collision_monitor
