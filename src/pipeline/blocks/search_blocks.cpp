// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/blocks/search_blocks.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <cmath>

#include "pipeline/blocks/block_lanes-inl.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/blocks/place_lanes-inl.h"
#include "pipeline/blocks/search_blocks.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Measures all pairs of a part.
struct MeasureAll {
  std::vector<double>& distances;

  static void begin(const PairBlock&) {}

  template <class CoreOne, class CoreRow>
  HWY_INLINE bool visit(const BodyRows& rows, const BlockPart& part) const {
    storeByPair(part, measureAllOfPart<CoreOne, CoreRow>(rows, part), distances);
    return true;
  }
};

/// Keeps the nearest pair.
struct FindNearest {
  const PassedPairs& passed;
  NearestPair& best;

  static void begin(const PairBlock&) {}

  template <class CoreOne, class CoreRow>
  HWY_INLINE bool visit(const BodyRows& rows, const BlockPart& part) const {
    std::uint32_t which = bitsOf(mayBeNearer(rows, part, best.distance)) & part.is_pair;
    if (which == 0) {
      return true;
    }
    const Number distance = measurePart<CoreOne, CoreRow>(rows, part, best.distance, which);
    which &= bitsOf(hn::Lt(distance, number(best.distance)));
    forLanes(part, which, distance, [&](std::uint32_t pair, std::size_t, double value) HWY_ATTR {
      if (value < best.distance && passed.is_passed[passed.group_of[pair]] == 0) {
        best = {idAt<PairId>(pair), value};
      }
    });
    return true;
  }
};

/// Bodies that are placed when a search first needs them.
struct LateBodies {
  const CycleSetup& setup;
  const LinkPoses& poses;
  BodyRows& rows;
  std::uint32_t placed{0};  ///< how many of PairBlocks::arrivals
};

/// Not inlined: within the search the compiler has too few registers for both.
HWY_NOINLINE void placeUpTo(std::uint32_t arrived, LateBodies& bodies) {
  for (; bodies.placed < arrived; ++bodies.placed) {
    placeGroup(bodies.setup.slot_groups, bodies.setup.blocks.arrivals[bodies.placed], bodies.poses,
               bodies.rows);
  }
}

/// Keeps the first contact.
struct FindContact {
  const ContactDistances& limits;
  FoundContact& found;
  LateBodies* late;  ///< null: all bodies are placed

  HWY_INLINE void begin(const PairBlock& block) const {
    if (late != nullptr && late->placed < block.arrived) {
      placeUpTo(block.arrived, *late);
    }
  }

  template <class CoreOne, class CoreRow>
  HWY_INLINE bool visit(const BodyRows& rows, const BlockPart& part) const {
    std::uint32_t which = bitsOf(mayBeNearer(rows, part, limits.largest)) & part.is_pair;
    if (which == 0) {
      return true;
    }
    const Number distance = measureInKernel<CoreOne, CoreRow>(rows, part, limits.largest, which);
    which &= bitsOf(hn::Not(hn::Gt(distance, number(limits.largest))));
    if (which == 0) {
      return true;
    }
    bool is_open = true;
    forLanes(part, which, distance,
             [&](std::uint32_t pair, std::size_t lane, double value) HWY_ATTR {
               if (!is_open) {
                 return;
               }
               if (std::isnan(value)) {
                 value = plainAt<CoreOne, CoreRow>(rows, part, lane);
                 found.has_unknown = found.has_unknown || std::isnan(value);
               }
               if (value <= limits.of_pair[pair]) {
                 found.contact = {idAt<PairId>(pair), value};
                 is_open = false;
               }
             });
    return is_open;
  }
};

/// False if a visitor ended the search.
template <class CoreOne, class CoreRow, class Visitor>
bool visitRange(const PairBlocks& blocks, const BlockRange& range, const BodyRows& rows,
                const Visitor& visitor) {
  for (std::size_t i = range.first; i < range.last; ++i) {
    const PairBlock& block = blocks.blocks[i];
    visitor.begin(block);
    const bool goes_on = forParts(block, [&](std::size_t, const BlockPart& part) HWY_ATTR {
      return visitor.template visit<CoreOne, CoreRow>(rows, part);
    });
    if (!goes_on) {
      return false;
    }
  }
  return true;
}

template <class CoreOne, class Visitor>
bool visitKind(const PairBlocks& blocks, const BlockRange& range, const BodyRows& rows,
               const Visitor& visitor) {
  return range.row == CoreKind::point ? visitRange<CoreOne, PointCore>(blocks, range, rows, visitor)
         : range.row == CoreKind::segment
             ? visitRange<CoreOne, SegmentCore>(blocks, range, rows, visitor)
             : visitRange<CoreOne, BoxCore>(blocks, range, rows, visitor);
}

template <class Visitor>
void visitBlocks(const PairBlocks& blocks, const BodyRows& rows, const Visitor& visitor) {
  for (const BlockRange& range : blocks.ranges) {
    const bool goes_on =
        range.one == CoreKind::point     ? visitKind<PointCore>(blocks, range, rows, visitor)
        : range.one == CoreKind::segment ? visitKind<SegmentCore>(blocks, range, rows, visitor)
                                         : visitKind<BoxCore>(blocks, range, rows, visitor);
    if (!goes_on) {
      return;
    }
  }
}

void measureInLanes(const PairBlocks& blocks, const BodyRows& rows,
                    std::vector<double>& distances) {
  visitBlocks(blocks, rows, MeasureAll{distances});
}

void searchInLanes(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                   NearestPair& best) {
  visitBlocks(blocks, rows, FindNearest{passed, best});
}

void findContactInLanes(const PairBlocks& blocks, const BodyRows& rows,
                        const ContactDistances& limits, FoundContact& found) {
  visitBlocks(blocks, rows, FindContact{limits, found, nullptr});
}

void placeInRows(const CycleSetup& setup, const LinkPoses& poses, BodyRows& rows) {
  for (std::size_t i = 0; i < setup.slot_groups.size(); ++i) {
    placeGroup(setup.slot_groups, i, poses, rows);
  }
}

void placeAndFindContact(const CycleSetup& setup, const LinkPoses& poses,
                         const ContactDistances& limits, BodyRows& rows, FoundContact& found) {
  LateBodies late{setup, poses, rows, 0};
  visitBlocks(setup.blocks, rows, FindContact{limits, found, &late});
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(measureInLanes);
HWY_EXPORT(searchInLanes);
HWY_EXPORT(findContactInLanes);
HWY_EXPORT(placeInRows);
HWY_EXPORT(placeAndFindContact);
}  // namespace

void measureBlocks(const PairBlocks& blocks, const BodyRows& rows,
                   std::vector<double>& distances) noexcept {
  HWY_DYNAMIC_DISPATCH(measureInLanes)(blocks, rows, distances);
}

void searchBlocks(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                  NearestPair& best) noexcept {
  HWY_DYNAMIC_DISPATCH(searchInLanes)(blocks, rows, passed, best);
}

void findContact(const PairBlocks& blocks, const BodyRows& rows, const ContactDistances& limits,
                 FoundContact& found) noexcept {
  HWY_DYNAMIC_DISPATCH(findContactInLanes)(blocks, rows, limits, found);
}

void findContact(const CycleSetup& setup, const LinkPoses& poses, const ContactDistances& limits,
                 BodyRows& rows, FoundContact& found) noexcept {
  HWY_DYNAMIC_DISPATCH(placeAndFindContact)(setup, poses, limits, rows, found);
}

ContactDistances contactDistancesOf(const CycleSetup& setup) {
  ContactDistances limits;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    limits.of_pair.push_back(contactOfBodies(setup, idAt<PairId>(i)));
    limits.largest = std::max(limits.largest, limits.of_pair.back());
  }
  return limits;
}

void placeRows(const CycleSetup& setup, const LinkPoses& poses, BodyRows& rows) noexcept {
  HWY_DYNAMIC_DISPATCH(placeInRows)(setup, poses, rows);
}

}  // namespace collision_monitor
#endif
