// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/narrow_phase/convex_distance.h"
#include "motion/screw_motion.h"
#include "narrow_phase/mesh/mesh_distance.h"

/// Finds when two bodies on screw motions first come within a distance of each other.
///
/// Conservative advancement: from a time at which the bodies are apart, time advances only as far
/// as the gap lasts at the greatest possible closing speed. So no contact is missed, however thin
/// or fast the bodies are, and the times converge to the first contact from below.
///
/// Frames: world. Units: metres; times are shares of the interval, 0 to 1.
/// Source: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (1996), section 2.3,
/// for the method; Zhang, Lee, Kim, "Interactive continuous collision detection for non-convex
/// polyhedra" (2006), for motion bounds along a direction; Tang, Kim, Manocha, "C2A: Controlled
/// Conservative Advancement for Continuous Collision Detection of Polygonal Models" (2009), for
/// bounds of the nodes of hierarchies. The bounds themselves are in src/motion/approach.h.
namespace collision_monitor {

/// A ball that holds a body, in its frame. Units: metres. An infinite radius: a half space.
struct Ball {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

/// The ball of a geometry. Tests every vertex of a hull, so call it at set-up.
Ball ballOf(const ConvexGeometry& geometry) noexcept;
Ball ballOf(const Shape& shape) noexcept;
Ball ballOf(const MeshTree& tree) noexcept;

enum class SweepState : unsigned char {
  clear,      ///< farther apart than contact_distance during the whole interval: proven
  contact,    ///< first within contact_distance at this time, clear before: proven
  undecided,  ///< clear up to this time: proven; the budget ran out, or a distance stayed unsettled
  unknown,    ///< a motion is not finite: nothing is known
};

struct SweptContact {
  SweepState state{SweepState::unknown};
  double time{0.0};
  SignedDistance measured;  ///< of contact, at that time
  std::uint32_t work{0};    ///< distances measured; for meshes, nodes opened and triangles measured
};

/// What counts as contact, when to look for it, and the budget.
struct SweepLimits {
  double contact_distance{0.0};  ///< [m] bodies this near are in contact
  double tolerance{1e-7};        ///< [m] contact is also reported up to this much farther
  double from{0.0};              ///< earlier times are known to be clear
  double until{1.0};             ///< so are this time and later ones
  std::uint32_t budget{2000};    ///< limit of SweptContact::work
};

struct MovingShape {
  const Shape& shape;
  const ScrewMotion& motion;
};

struct MovingConvex {
  const ConvexGeometry& geometry;
  const Ball& ball;  ///< ballOf(geometry)
  const ScrewMotion& motion;
};

struct MovingMesh {
  const MeshTree& tree;
  const ScrewMotion& motion;
};

/// Convex bodies. A plane separates them, so only motion across it counts.
///
/// Pairs without rotation are settled by timeOfContact if they are two spheres, two boxes, or a
/// half space with a sphere or box.
/// @param search as in signedDistanceBetween.
SweptContact firstContact(const MovingShape& a, const MovingShape& b,
                          const SweepLimits& limits) noexcept;
SweptContact firstContact(const MovingConvex& a, const MovingConvex& b, const SweepLimits& limits,
                          ConvexSearch& search) noexcept;

/// Two meshes, by their hierarchies. Children are visited only if their parents may meet in the
/// rest of the interval, at the greatest speeds of parts so far from the center.
/// Limits: surfaces count, and the inside of open meshes. A body inside a closed mesh at the start
/// is not seen until it comes out. A negative contact_distance counts as 0.
SweptContact firstContact(const MovingMesh& a, const MovingMesh& b, const SweepLimits& limits,
                          MeshQueryMemory& memory) noexcept;
/// A mesh and a solid shape, by their distances. Limits: as for two meshes.
SweptContact firstContact(const MovingMesh& a, const MovingShape& b, const SweepLimits& limits,
                          MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
