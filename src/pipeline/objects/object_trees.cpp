// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/objects/object_trees.h"

#include <algorithm>

#include "broad_phase/marked_pairs.h"
#include "collision_monitor/geometry/bounds.h"
#include "geometry/constants.h"
#include "narrow_phase/distance.h"
#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {
namespace {

/// Marks the pairs of loose bodies.
void findLoosePairs(CycleBuffers& buffers) noexcept {
  ObjectTrees& trees = buffers.trees;
  for (std::size_t i = 0; i < trees.loose.size(); ++i) {
    trees.bounds.boxes[i] = buffers.bounds.boxes[index(trees.loose[i])];
    trees.bounds.known[i] = buffers.bounds.known[index(trees.loose[i])];
  }
  findCandidates(buffers.broad_phase, trees.bounds, trees.table, buffers.candidates);
  for (const PairId pair : buffers.candidates) {
    markPair(trees.loose_pair[index(pair)], buffers.broad_phase.marks);
  }
}

/// Objects that rest keep how far their bounds are grown.
void growTrees(const CycleSetup& setup, double reach, CycleBuffers& buffers) noexcept {
  const auto is_of = [](const IndexRange& moved, const CarriedObjects& objects) {
    return moved.first <= objects.first_body && objects.last_body <= moved.last;
  };
  for (std::size_t tree = 0; tree < setup.carried.size(); ++tree) {
    const CarriedObjects& objects = setup.carried[tree];
    const auto& moved = buffers.body_poses.moved.bodies;
    if (std::none_of(moved.begin(), moved.end(),
                     [&](const IndexRange& range) { return is_of(range, objects); })) {
      continue;
    }
    double ahead = 0.0;
    double travel = 0.0;
    for (std::size_t i = objects.first_body; i < objects.last_body; ++i) {
      ahead = buffers.bounds.ahead[i] > ahead ? buffers.bounds.ahead[i] : ahead;  // may be NaN
      travel = std::max(travel, buffers.sweep.body_travel[i]);
    }
    buffers.trees.trees[tree].grown = 0.5 * reach + ahead + travel;
  }
}

/// The box in the frame of a tree that holds a box of the world.
/// @param grown [m] to every side, still in the world
SmallBox boxInTree(const Pose& tree_from_world, const Aabb& box, double grown) noexcept {
  constexpr double kRounding = 1e-9;  // of coordinates
  const Eigen::Vector3d center = tree_from_world * (0.5 * (box.min + box.max));
  const Eigen::Vector3d in_world = 0.5 * (box.max - box.min) + Eigen::Vector3d::Constant(grown);
  const double rounding =
      kRounding * (1.0 + in_world.norm() + center.norm() + tree_from_world.translation.norm());
  const Eigen::Vector3d half =
      tree_from_world.rotation.cwiseAbs() * in_world + Eigen::Vector3d::Constant(rounding);
  if (!half.allFinite() || !center.allFinite()) {
    return smallBoxOf(
        {Eigen::Vector3d::Constant(-kInfinity), Eigen::Vector3d::Constant(kInfinity)});
  }
  return smallBoxOf({center - half, center + half});
}

/// Marks the pairs of a body with each object of a tree whose bounds may meet.
/// @param pair_at takes the place of the object; kNone: no pair
template <class PairAt>
void seek(const ObjectTree& tree, const Pose& tree_from_world, const Aabb& box,
          const PairAt& pair_at, std::vector<std::uint64_t>& marks) noexcept {
  tree.tree.visitMeeting(boxInTree(tree_from_world, box, tree.grown), [&](std::uint32_t place) {
    const std::uint32_t pair = pair_at(place);
    if (pair != kNone) {
      markPair(PairId{pair}, marks);
    }
  });
}

void findInTree(const CycleSetup& setup, const LinkPoses& poses, std::size_t place,
                CycleBuffers& buffers) noexcept {
  const CarriedObjects& objects = setup.carried[place];
  const BodyBounds& bounds = buffers.bounds;
  if (bounds.known[objects.first_body] == 0) {
    return;
  }
  const ObjectTree& tree = buffers.trees.trees[place];
  const Pose tree_from_world = inverse(poses.world_from_link[objects.first_link]);
  for (std::size_t i = 0; i < buffers.trees.loose.size(); ++i) {
    const std::size_t body = index(buffers.trees.loose[i]);
    if (bounds.known[body] != 0) {
      const std::uint32_t* const pairs =
          tree.pair_of.data() + i * (objects.last_body - objects.first_body);
      seek(
          tree, tree_from_world, bounds.boxes[body],
          [&](std::uint32_t object) { return pairs[object]; }, buffers.broad_phase.marks);
    }
  }
  for (const BodyId seeker : buffers.trees.seekers) {
    if (bounds.known[index(seeker)] != 0) {
      seek(
          tree, tree_from_world, bounds.boxes[index(seeker)],
          [&](std::uint32_t object) {
            PairId pair{kNone};
            setup.table.find(seeker, idAt<BodyId>(objects.first_body + object), pair);
            return static_cast<std::uint32_t>(index(pair));
          },
          buffers.broad_phase.marks);
    }
  }
}

/// The nearest pair of one body with the objects of a tree.
struct TreeSearch {
  const CycleSetup& setup;
  const BodyPoses& body_poses;
  const std::vector<unsigned char>& is_passed;
  BodyId seeker;
  NearestPair& best;

  void look(BodyId object) const noexcept {
    PairId pair{};
    const std::size_t a = index(seeker);
    const std::size_t b = index(object);
    const Ball& ball_a = body_poses.balls[a];
    const Ball& ball_b = body_poses.balls[b];
    const double gap = (ball_b.center - ball_a.center).norm() - ball_a.radius - ball_b.radius;
    if (gap > best.distance || !setup.table.find(seeker, object, pair) ||
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

void findPairs(const CycleSetup& setup, const LinkPoses& poses, double reach,
               CycleBuffers& buffers) noexcept {
  if (setup.carried.empty()) {
    findCandidates(buffers.broad_phase, buffers.bounds, setup.table, buffers.candidates);
    return;
  }
  findLoosePairs(buffers);
  growTrees(setup, reach, buffers);
  for (std::size_t tree = 0; tree < setup.carried.size(); ++tree) {
    findInTree(setup, poses, tree, buffers);
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
    const Pose tree_from_world = inverse(poses.world_from_link[objects.first_link]);
    const auto seek_from = [&](BodyId seeker) {
      if (body_poses.known[index(seeker)] == 0) {
        return;
      }
      const Ball& ball = body_poses.balls[index(seeker)];
      const TreeSearch search{setup, body_poses, is_passed, seeker, best};
      double within = best.distance + ball.radius;
      trees.trees[tree].tree.visitNear(tree_from_world * ball.center, within,
                                       [&](std::uint32_t place) {
                                         search.look(idAt<BodyId>(objects.first_body + place));
                                         within = best.distance + ball.radius;
                                       });
    };
    std::for_each(trees.loose.begin(), trees.loose.end(), seek_from);
    std::for_each(trees.seekers.begin(), trees.seekers.end(), seek_from);
  }
}

}  // namespace collision_monitor
