// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <utility>

#include "collision_monitor/geometry/bounds.h"
#include "model/object_links.h"
#include "pipeline/objects/object_trees.h"

namespace collision_monitor {
namespace {

/// The boxes of the shapes that one carrier carries, in the frame of the first object.
std::vector<Aabb> boxesOf(const CycleSetup& setup, const CarriedObjects& objects) {
  std::vector<Aabb> boxes;
  for (std::size_t i = objects.first_body; i < objects.last_body; ++i) {
    const Body& body = setup.bodies[i];
    const Pose first_from_body =
        poseBeside(setup.model, idAt<LinkId>(objects.first_link), body.link) * body.link_from_body;
    boxes.push_back(aabbOf(body.shape, first_from_body, 0.0));
  }
  return boxes;
}

/// By BodyId: the tree that holds the body, or kNone.
std::vector<std::uint32_t> treesOfBodies(const CycleSetup& setup) {
  std::vector<std::uint32_t> tree_of(setup.bodies.size(), kNone);
  for (std::uint32_t tree = 0; tree < setup.carried.size(); ++tree) {
    const CarriedObjects& objects = setup.carried[tree];
    std::fill(tree_of.begin() + static_cast<std::ptrdiff_t>(objects.first_body),
              tree_of.begin() + static_cast<std::ptrdiff_t>(objects.last_body), tree);
  }
  return tree_of;
}

/// What holds each body.
struct Places {
  std::vector<std::uint32_t> tree;   ///< by BodyId: kNone for loose bodies
  std::vector<std::uint32_t> loose;  ///< by BodyId: place among the loose bodies
};

Places findPlaces(const CycleSetup& setup, ObjectTrees& trees) {
  Places places{treesOfBodies(setup), std::vector<std::uint32_t>(setup.bodies.size(), kNone)};
  for (std::size_t i = 0; i < places.tree.size(); ++i) {
    if (places.tree[i] == kNone) {
      places.loose[i] = static_cast<std::uint32_t>(trees.loose.size());
      trees.loose.push_back(idAt<BodyId>(i));
    }
  }
  return places;
}

/// Fills the table of loose bodies.
void listLoosePairs(const CycleSetup& setup, const Places& places, ObjectTrees& trees) {
  std::vector<BodyPair> pairs;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    const std::uint32_t a = places.loose[index(pair.a)];
    const std::uint32_t b = places.loose[index(pair.b)];
    if (a != kNone && b != kNone) {
      pairs.push_back({BodyId{a}, BodyId{b}});
      trees.loose_pair.push_back(idAt<PairId>(i));
    }
  }
  trees.table = PairTable(std::move(pairs), trees.loose.size());
}

std::size_t sizeOf(const CarriedObjects& objects) noexcept {
  return objects.last_body - objects.first_body;
}

/// Calls `use(tree, seeker, object, pair)` for each pair with an object of a tree.
template <class Use>
void forTreePairs(const CycleSetup& setup, const Places& places, const Use& use) {
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    const std::uint32_t a = places.tree[index(pair.a)];
    const std::uint32_t b = places.tree[index(pair.b)];
    const bool seeks_a =
        b == kNone || (a != kNone && sizeOf(setup.carried[b]) <= sizeOf(setup.carried[a]));
    if (a != kNone || b != kNone) {
      seeks_a ? use(a, pair.b, pair.a, i) : use(b, pair.a, pair.b, i);
    }
  }
}

/// Fills which bodies have pairs with objects of each tree, and which.
void listTreePairs(const CycleSetup& setup, const Places& places, ObjectTrees& trees) {
  const std::size_t bodies = setup.bodies.size();
  std::vector<std::uint32_t> row_of(trees.trees.size() * bodies, kNone);
  forTreePairs(setup, places, [&](std::uint32_t tree, BodyId seeker, BodyId, std::size_t) {
    row_of[tree * bodies + index(seeker)] = 0;
  });
  for (std::size_t tree = 0; tree < trees.trees.size(); ++tree) {
    ObjectTree& sought = trees.trees[tree];
    std::uint32_t rows = 0;
    for (std::size_t body = 0; body < bodies; ++body) {
      std::uint32_t& row = row_of[tree * bodies + body];
      if (row != kNone) {
        row = places.tree[body] == kNone ? rows++ : kNone;
        sought.seekers.push_back({idAt<BodyId>(body), row});
      }
    }
    sought.pair_of.resize(rows * sizeOf(setup.carried[tree]), kNone);
  }
  forTreePairs(
      setup, places, [&](std::uint32_t tree, BodyId seeker, BodyId object, std::size_t pair) {
        const CarriedObjects& objects = setup.carried[tree];
        const std::size_t row = row_of[tree * bodies + index(seeker)];
        if (row != kNone) {
          trees.trees[tree].pair_of[row * sizeOf(objects) + index(object) - objects.first_body] =
              static_cast<std::uint32_t>(pair);
        }
      });
}

/// The blocks with a pair of two loose bodies.
PairBlocks looseBlocks(const CycleSetup& setup, const std::vector<std::uint32_t>& tree_of) {
  std::vector<unsigned char> is_loose(setup.bodies.size() + kBlockLanes, 0);  // by slot
  for (std::size_t i = 0; i < tree_of.size(); ++i) {
    is_loose[setup.blocks.slot_of[i]] = tree_of[i] == kNone ? 1 : 0;
  }
  const auto has_pair = [&](const PairBlock& block) {
    bool has_loose = false;
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
      has_loose |= (block.is_pair >> lane & 1U) != 0 && is_loose[block.first + lane] != 0;
    }
    return has_loose && is_loose[block.one] != 0;
  };
  PairBlocks blocks;
  blocks.slot_of = setup.blocks.slot_of;
  for (BlockRange range : setup.blocks.ranges) {
    const auto first = setup.blocks.blocks.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto last = setup.blocks.blocks.begin() + static_cast<std::ptrdiff_t>(range.last);
    range.first = blocks.blocks.size();
    std::copy_if(first, last, std::back_inserter(blocks.blocks), has_pair);
    range.last = blocks.blocks.size();
    blocks.ranges.push_back(range);
  }
  return blocks;
}

}  // namespace

ObjectTrees makeObjectTrees(const CycleSetup& setup, BroadPhaseKind kind) {
  ObjectTrees trees;
  if (setup.carried.empty() || kind == BroadPhaseKind::brute_force) {
    return trees;
  }
  for (const CarriedObjects& objects : setup.carried) {
    trees.trees.push_back({RigidTree(boxesOf(setup, objects)), 0.0, true, {}, {}});
    const std::size_t room = trees.trees.back().tree.roomForFound();
    trees.found.resize(std::max(trees.found.size(), room));
  }
  const Places places = findPlaces(setup, trees);
  listLoosePairs(setup, places, trees);
  listTreePairs(setup, places, trees);
  trees.bounds.boxes.resize(trees.loose.size());
  trees.bounds.known.resize(trees.loose.size(), 0);
  trees.blocks = looseBlocks(setup, places.tree);
  return trees;
}

}  // namespace collision_monitor
