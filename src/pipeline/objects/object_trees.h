// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "broad_phase/rigid_tree.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

/// The broad phase of set-ups with very many objects: a tree for the objects of each carrier, and a
/// method of the broad phase for all other bodies.
namespace collision_monitor {

/// A body that has pairs with objects of a tree.
struct TreeSeeker {
  BodyId body{};
  std::uint32_t row{kNone};  ///< of ObjectTree::pair_of; kNone for bodies of trees
};

/// The objects of one carrier.
struct ObjectTree {
  RigidTree tree;        ///< in the frame of the first object
  double moves{0.0};     ///< [m] how far its objects moved or may move within the horizon
  bool are_known{true};  ///< the velocities of all its objects are
  /// In order of body. Of two trees with pairs the bodies of the smaller one seek.
  std::vector<TreeSeeker> seekers;
  /// The pair of each seeker that is loose with each object, at its row * objects + place of the
  /// object: its PairId, or kNone.
  std::vector<std::uint32_t> pair_of;
};

struct ObjectTrees {
  std::vector<ObjectTree> trees;     ///< by CycleSetup::carried
  std::vector<BodyId> loose;         ///< bodies in no tree, in order
  BodyBounds bounds;                 ///< of the loose bodies
  PairTable table;                   ///< pairs of loose bodies, as places in `loose`
  std::vector<PairId> loose_pair;    ///< by PairId of this table: the pair of the set-up
  PairBlocks blocks;                 ///< those of the set-up that hold pairs of loose bodies
  std::vector<std::uint32_t> found;  ///< room for a search in any tree
};

struct CycleBuffers;

/// @return without trees for set-ups without CycleSetup::carried, and for the method that tests all
/// pairs
ObjectTrees makeObjectTrees(const CycleSetup& setup, BroadPhaseKind kind);

/// Fills the candidates: pairs of the table whose bounds meet, sorted by id. Those of a body and an
/// object in a tree are an oriented box about the body and a box along the axes of the carrier, and
/// they meet within how near both must be to matter.
/// @param reach [m] as for boundBodies, `margin` included
/// @param margin [m] how much farther than matters pairs may be; 0 unless they are listed
/// @pre growTrees was called in this cycle
void findPairs(const CycleSetup& setup, const LinkPoses& poses, double reach, double margin,
               CycleBuffers& buffers) noexcept;

/// Takes how far the objects of trees moved or may move. Objects that rest keep it.
void growTrees(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

/// Finds the nearest pair with an object in a tree that is not passed, if it is nearer than `best`.
void searchTrees(const CycleSetup& setup, const LinkPoses& poses, const BodyPoses& body_poses,
                 const ObjectTrees& trees, const std::vector<unsigned char>& is_passed,
                 NearestPair& best) noexcept;

}  // namespace collision_monitor
