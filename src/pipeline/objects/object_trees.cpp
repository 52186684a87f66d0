// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/objects/object_trees.h"

#include <algorithm>
#include <cmath>

#include "broad_phase/marked_pairs.h"
#include "collision_monitor/geometry/bounds.h"
#include "geometry/constants.h"
#include "narrow_phase/distance.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/look_ahead/bound_bodies.h"

namespace collision_monitor {
namespace {

/// Marks the pairs of loose bodies. Their bounds are seen from the first robot's root, so that a
/// base that moves does not make the pairs of its robot candidates. For a list they are seen from
/// the world: it ends by the motions that bodies have there.
void findLoosePairs(const CycleSetup& setup, const LinkPoses& poses, bool is_for_list,
                    CycleBuffers& buffers) noexcept {
  ObjectTrees& trees = buffers.trees;
  const Twist shared = sharedTwist(setup, poses.velocities);
  for (std::size_t i = 0; i < trees.loose.size(); ++i) {
    const std::size_t body = index(trees.loose[i]);
    Aabb& box = trees.bounds.boxes[i];
    box = buffers.bounds.boxes[body];
    trees.bounds.known[i] = buffers.bounds.known[body];
    const double more = travelAhead(setup, poses, setup.bodies[body], shared, setup.ahead.horizon) -
                        buffers.bounds.ahead[body];
    if (!is_for_list && std::isfinite(more)) {
      box.min.array() -= more;
      box.max.array() += more;
    }
  }
  findCandidates(buffers.broad_phase, trees.bounds, trees.table, buffers.candidates);
  for (const PairId pair : buffers.candidates) {
    markPair(index(trees.loose_pair[index(pair)]), buffers.broad_phase.marks);
  }
}

/// [m] How near a body and objects of a tree must be to matter, whatever their limits: at least
/// NearBodies::limitOf where motions are known, else at least what boundBodies grows boxes by.
struct SeekReach {
  double at_rest;  ///< that of boundBodies
  double stop;     ///< PairReach::stop of any pair, and the margin of a list

  double of(const ObjectTree& tree, double ahead, double travel) const noexcept {
    const double moves = (ahead > travel ? ahead : travel) + tree.moves;  // `ahead` may be NaN
    const bool are_known = tree.are_known && std::isfinite(ahead);
    return are_known ? std::max(at_rest, stop + moves) : at_rest + moves;
  }
};

/// The pair of a seeker with an object; kNone if there is none.
/// @param place of the object in its tree
PairId pairOf(const CycleSetup& setup, const CarriedObjects& objects, const ObjectTree& tree,
              const TreeSeeker& seeker, std::size_t place) noexcept {
  PairId pair{kNone};
  if (seeker.row == kNone) {
    setup.table.find(seeker.body, idAt<BodyId>(objects.first_body + place), pair);
    return pair;
  }
  return PairId{tree.pair_of[seeker.row * (objects.last_body - objects.first_body) + place]};
}

/// Marks the pairs with objects of a tree that are near.
void findInTree(const CycleSetup& setup, const LinkPoses& poses, const SeekReach& reach,
                std::size_t place, CycleBuffers& buffers) noexcept {
  const CarriedObjects& objects = setup.carried[place];
  const BodyBounds& bounds = buffers.bounds;
  if (bounds.known[objects.first_body] == 0) {
    return;
  }
  const ObjectTree& tree = buffers.trees.trees[place];
  const Pose tree_from_world = inverse(poses.world_from_link[objects.first_link]);
  for (const TreeSeeker& seeker : tree.seekers) {
    const std::size_t body = index(seeker.body);
    if (bounds.known[body] == 0) {
      continue;
    }
    const Core& core = setup.cores[body];
    const double near = reach.of(tree, bounds.ahead[body], buffers.sweep.body_travel[body]);
    const NearBox box = nearBoxOf(tree_from_world * buffers.body_poses.world_from_body[body],
                                  core.half_extents, core.radius + near);
    for (const std::uint32_t object : tree.tree.findNear(box, buffers.trees.found)) {
      const PairId pair = pairOf(setup, objects, tree, seeker, object);
      if (pair != PairId{kNone}) {
        markPair(index(pair), buffers.broad_phase.marks);
      }
    }
  }
}

/// The nearest pair of one body with the objects of a tree.
struct TreeSearch {
  const CycleSetup& setup;
  const BodyPoses& body_poses;
  const std::vector<unsigned char>& is_passed;
  NearestPair& best;

  void look(BodyId seeker, BodyId object, PairId pair) const noexcept {
    const std::size_t a = index(seeker);
    const std::size_t b = index(object);
    const Ball& ball_a = body_poses.balls[a];
    const Ball& ball_b = body_poses.balls[b];
    const double gap = (ball_b.center - ball_a.center).norm() - ball_a.radius - ball_b.radius;
    if (gap > best.distance || pair == PairId{kNone} ||
        is_passed[setup.element_pair_of[index(pair)]] != 0) {
      return;
    }
    const double distance = distanceBetween(setup.bodies[a].shape, body_poses.world_from_body[a],
                                            setup.bodies[b].shape, body_poses.world_from_body[b])
                                .distance;
    if (distance < best.distance || (distance == best.distance && pair < best.pair)) {
      best = {pair, distance};
    }
  }
};

}  // namespace

void growTrees(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  const auto is_of = [](const IndexRange& moved, const CarriedObjects& objects) {
    return moved.first <= objects.first_body && objects.last_body <= moved.last;
  };
  for (std::size_t tree = 0; tree < buffers.trees.trees.size(); ++tree) {
    const CarriedObjects& objects = setup.carried[tree];
    const auto& moved = buffers.body_poses.moved.bodies;
    if (std::none_of(moved.begin(), moved.end(),
                     [&](const IndexRange& range) { return is_of(range, objects); })) {
      continue;
    }
    ObjectTree& grown = buffers.trees.trees[tree];
    grown.moves = 0.0;
    grown.are_known = true;
    for (std::size_t i = objects.first_body; i < objects.last_body; ++i) {
      const double ahead = buffers.bounds.ahead[i];
      grown.are_known &= std::isfinite(ahead);
      grown.moves = std::max({grown.moves, buffers.sweep.body_travel[i], ahead});  // not a NaN
    }
  }
}

void findPairs(const CycleSetup& setup, const LinkPoses& poses, double reach, double margin,
               CycleBuffers& buffers) noexcept {
  if (buffers.trees.trees.empty()) {
    findCandidates(buffers.broad_phase, buffers.bounds, setup.table, buffers.candidates);
    return;
  }
  findLoosePairs(setup, poses, margin > 0.0, buffers);
  const SeekReach seek{reach, buffers.activation.farthest.stop + margin};
  for (std::size_t tree = 0; tree < setup.carried.size(); ++tree) {
    findInTree(setup, poses, seek, tree, buffers);
  }
  takeMarked(buffers.broad_phase.marks, buffers.candidates);
}

void searchTrees(const CycleSetup& setup, const LinkPoses& poses, const BodyPoses& body_poses,
                 const ObjectTrees& trees, const std::vector<unsigned char>& is_passed,
                 NearestPair& best) noexcept {
  for (std::size_t tree = 0; tree < trees.trees.size(); ++tree) {
    const CarriedObjects& objects = setup.carried[tree];
    if (body_poses.known[objects.first_body] == 0) {
      continue;
    }
    const ObjectTree& sought = trees.trees[tree];
    const Pose tree_from_world = inverse(poses.world_from_link[objects.first_link]);
    const TreeSearch search{setup, body_poses, is_passed, best};
    for (const TreeSeeker& seeker : sought.seekers) {
      if (body_poses.known[index(seeker.body)] == 0) {
        continue;
      }
      const Ball& ball = body_poses.balls[index(seeker.body)];
      double within = best.distance + ball.radius;
      sought.tree.visitNear(tree_from_world * ball.center, within, [&](std::uint32_t place) {
        search.look(seeker.body, idAt<BodyId>(objects.first_body + place),
                    pairOf(setup, objects, sought, seeker, place));
        within = best.distance + ball.radius;
      });
    }
  }
}

}  // namespace collision_monitor
