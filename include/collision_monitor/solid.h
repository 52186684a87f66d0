// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/arguments.h"
#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/model/mesh_reading.h"
#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// Two solids with poses, without a robot.
namespace collision_monitor {

struct SolidParts;
struct SolidWork;

/// Something that can be measured. Never changes, so threads may share it. Copies are cheap and
/// share what is inside. Units: metres; each is centered at its frame's origin, with its axis along
/// z, unless it is made of points.
class Solid {
 public:
  /// Geometry of a URDF. A mesh is its triangles, and its inside if it has one.
  /// @throws ArgumentError for lengths that are negative or not finite, and meshes without
  /// vertices, with vertices that are not finite or triangles of missing vertices
  explicit Solid(const Geometry& geometry);

  static Solid sphere(double radius);                  ///< @param radius [m]
  static Solid capsule(double radius, double length);  ///< between the centers of its caps
  static Solid box(const Eigen::Vector3d& size);  ///< @param size [m] whole lengths along x, y, z
  static Solid cylinder(double radius, double length);  ///< @param length [m] along z, as a whole
  /// The tip is at +length / 2. Made of a hull around the cone that sticks out by at most 0.2 % of
  /// the radius; its distances are lower bounds.
  static Solid cone(double radius, double length);
  /// The convex hull of points [m].
  static Solid hull(const std::vector<Eigen::Vector3d>& points);
  /// @param mesh triangles, and their inside if they have one. Vertices that no triangle uses do
  /// not count; without triangles, the vertices are points.
  static Solid mesh(const TriangleMesh& mesh);
  /// A mesh file: STL, DAE, OBJ, PLY.
  /// @throws ArgumentError if it cannot be read
  static Solid mesh(const std::filesystem::path& file,
                    const Eigen::Vector3d& scale = Eigen::Vector3d::Ones(),
                    const MeshReading& reading = {});

 private:
  friend class SolidQuery;
  friend struct SolidWork;
  explicit Solid(std::shared_ptr<const SolidParts> parts);

  std::shared_ptr<const SolidParts> parts_;
};

/// Kinds of shape that leastShape can make.
enum class ShapeKind : unsigned char { sphere, capsule, box, rounded_box };

/// The shape of a kind of least volume that holds all points, in their frame.
/// Error: every point is inside up to rounding. Spheres are the least; capsules and boxes are
/// within 1 %; rounded boxes are no larger than the other three. encloseTightly proves what it
/// encloses.
/// @throws ArgumentError if there is no point or one is not finite or beyond 1e6 m
PosedShape leastShape(ShapeKind kind, const std::vector<Eigen::Vector3d>& points);

/// The answer for two solids.
struct SolidDistance {
  SignedDistance measured;            ///< world frame; NaN where the quality is unknown
  Quality quality{Quality::unknown};  ///< of the distance
};

/// Measures two solids. Keeps scratch, and warm starts as long as the same two are asked about:
/// each thread needs its own.
///
/// Frames: answers are in the world frame. Error: as signedDistanceBetween; meshes as in
/// docs/accuracy.md. Overlaps of meshes that are not convex are Quality::estimate: at least that
/// deep. A pose that is not rigid, not finite or beyond kFarthest gives Quality::unknown and NaN.
class SolidQuery {
 public:
  SolidQuery();
  ~SolidQuery();
  SolidQuery(SolidQuery&& other) noexcept;  ///< the other one can only be assigned to or destroyed
  SolidQuery& operator=(SolidQuery&& other) noexcept;  ///< as the constructor

  /// @param within [m] > 0: beyond it the search may stop; the answer is then a lower bound of at
  /// least this, and its points may be NaN.
  /// @throws ArgumentError if `within` is not above 0
  SolidDistance distance(const Solid& a, const Pose& world_from_a, const Solid& b,
                         const Pose& world_from_b,
                         double within = std::numeric_limits<double>::infinity());

  /// Whether they touch or overlap, by the cheapest search that tells.
  /// @throws ArgumentError if a pose is not rigid, not finite or beyond kFarthest: yes and no would
  /// both be wrong
  bool collide(const Solid& a, const Pose& world_from_a, const Solid& b, const Pose& world_from_b);

 private:
  std::unique_ptr<SolidWork> work_;
};

}  // namespace collision_monitor
