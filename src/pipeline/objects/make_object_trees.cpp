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

/// Fills which pair each loose body and object are. @return by tree: whether its bodies seek
/// others. Of two trees with pairs the smaller one does.
std::vector<bool> listTreePairs(const CycleSetup& setup, const Places& places, ObjectTrees& trees) {
  std::vector<bool> seeks(setup.carried.size(), false);
  for (std::size_t tree = 0; tree < trees.trees.size(); ++tree) {
    trees.trees[tree].pair_of.resize(trees.loose.size() * sizeOf(setup.carried[tree]), kNone);
  }
  const auto add = [&](BodyId loose, BodyId object, std::uint32_t pair) {
    const std::uint32_t tree = places.tree[index(object)];
    const CarriedObjects& objects = setup.carried[tree];
    const std::size_t row = places.loose[index(loose)] * sizeOf(objects);
    trees.trees[tree].pair_of[row + index(object) - objects.first_body] = pair;
  };
  for (std::uint32_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    const std::uint32_t a = places.tree[index(pair.a)];
    const std::uint32_t b = places.tree[index(pair.b)];
    if (a != kNone && b != kNone) {
      seeks[sizeOf(setup.carried[a]) < sizeOf(setup.carried[b]) ? a : b] = true;
    } else if (a != kNone || b != kNone) {
      add(a == kNone ? pair.a : pair.b, a == kNone ? pair.b : pair.a, i);
    }
  }
  return seeks;
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

ObjectTrees makeObjectTrees(const CycleSetup& setup) {
  ObjectTrees trees;
  if (setup.carried.empty()) {
    return trees;
  }
  for (const CarriedObjects& objects : setup.carried) {
    trees.trees.push_back({RigidTree(boxesOf(setup, objects)), 0.0, {}});
  }
  const Places places = findPlaces(setup, trees);
  listLoosePairs(setup, places, trees);
  const std::vector<bool> seeks = listTreePairs(setup, places, trees);
  for (std::size_t i = 0; i < places.tree.size(); ++i) {
    if (places.tree[i] != kNone && seeks[places.tree[i]]) {
      trees.seekers.push_back(idAt<BodyId>(i));
    }
  }
  trees.bounds.boxes.resize(trees.loose.size());
  trees.bounds.known.resize(trees.loose.size(), 0);
  trees.blocks = looseBlocks(setup, places.tree);
  return trees;
}

}  // namespace collision_monitor
