// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/narrow_phase/convex_distance.h"
#include "motion/screw_motion.h"
#include "narrow_phase/mesh/mesh_distance.h"

/// When do two bodies on screw motions first come within a distance of each other?
///
/// From a time at which they are apart, time advances by no more than what the greatest speed at
/// which they can come nearer needs for the gap. So nothing is stepped over, however thin and fast,
/// and the times converge to the first contact from below.
///
/// Frames: world. Units: metres; times are shares of the interval, 0 to 1.
/// Source: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (1996), section 2.3,
/// for the method; Zhang, Lee, Kim, "Interactive continuous collision detection for non-convex
/// polyhedra" (2006), for motion bounds along a direction; Tang, Kim, Manocha, "C2A: Controlled
/// Conservative Advancement for Continuous Collision Detection of Polygonal Models" (2009), for
/// bounds of the nodes of hierarchies. The bounds themselves are in src/motion/approach.h.
namespace collision_monitor {

/// What holds a body, in its frame. Units: metres; an infinite radius holds a half space.
struct Ball {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

/// Looks at every vertex of a hull: for set-up.
Ball ballOf(const ConvexGeometry& geometry) noexcept;
Ball ballOf(const Shape& shape) noexcept;
Ball ballOf(const MeshTree& tree) noexcept;

enum class SweepState : unsigned char {
  clear,      ///< farther apart than asked for during the whole interval: proven
  contact,    ///< first as near as asked for at this time; clear before: proven
  undecided,  ///< clear up to this time: proven; steps ran out, or no distance could be settled
  unknown,    ///< a motion is not finite: nothing is known
};

struct SweptContact {
  SweepState state{SweepState::unknown};
  double time{0.0};
  SignedDistance measured;  ///< of contact, at that time
  std::uint32_t work{0};    ///< distances measured; of meshes, nodes opened and triangles measured
};

/// What is asked for, and how much work may go into it.
struct SweepLimits {
  double contact_distance{0.0};  ///< [m] this near is contact
  double tolerance{1e-7};        ///< [m] and so is this much farther
  double from{0.0};              ///< earlier times are known to be clear
  double until{1.0};             ///< and so are these and later ones
  std::uint32_t budget{2000};    ///< of steps
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

/// Convex bodies, which a plane parts: only what closes across it counts.
///
/// Pairs of spheres, and spheres, boxes with a half space or boxes with each other, that do not
/// turn are settled by timeOfContact.
/// @param search as in signedDistanceBetween.
SweptContact firstContact(const MovingShape& a, const MovingShape& b,
                          const SweepLimits& limits) noexcept;
SweptContact firstContact(const MovingConvex& a, const MovingConvex& b, const SweepLimits& limits,
                          ConvexSearch& search) noexcept;

/// Two meshes, by their hierarchies: children are looked at only where their parents may meet
/// in the rest of the interval, with the speeds that parts so far out have.
/// Limits: surfaces count, and of open meshes the inside. What is inside a closed mesh at the start
/// is not seen until it comes out. A negative contact_distance is taken as 0.
SweptContact firstContact(const MovingMesh& a, const MovingMesh& b, const SweepLimits& limits,
                          MeshQueryMemory& memory) noexcept;
/// A mesh and a solid shape, by their distances. Limits: as for two meshes.
SweptContact firstContact(const MovingMesh& a, const MovingShape& b, const SweepLimits& limits,
                          MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
