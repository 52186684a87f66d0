// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/blocks/search_blocks.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <cmath>

#include "pipeline/blocks/block_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Keeps all pairs within a distance.
struct CollectNear {
  double within;
  std::vector<NearestPair>& near;

  HWY_INLINE double reach() const { return within; }

  template <class CoreOne, class CoreRow>
  HWY_NOINLINE bool visit(const BodyRows& rows, BlockPart part, std::uint32_t which) const {
    const Number distance = measurePart<CoreOne, CoreRow>(rows, part, within, which);
    which &= bitsOf(hn::Le(distance, number(within)));
    forLanes(part, which, distance, [&](std::uint32_t pair, std::size_t, double value) HWY_ATTR {
      near.push_back({idAt<PairId>(pair), value});
    });
    return true;
  }
};

/// Keeps the nearest pair.
struct FindNearest {
  const PassedPairs& passed;
  NearestPair& best;

  HWY_INLINE double reach() const { return best.distance; }

  template <class CoreOne, class CoreRow>
  HWY_NOINLINE bool visit(const BodyRows& rows, BlockPart part, std::uint32_t which) const {
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

/// Keeps the first contact.
struct FindContact {
  const ContactDistances& limits;
  FoundContact& found;

  HWY_INLINE double reach() const { return limits.largest; }

  template <class CoreOne, class CoreRow>
  HWY_NOINLINE bool visit(const BodyRows& rows, BlockPart part, std::uint32_t which) const {
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

/// Visits the pairs whose bounding spheres are within reach. Visits are no part of this loop: most
/// parts have no such pair, and for them the loop stays short.
/// @return false if the visitor ended the search.
template <class CoreOne, class CoreRow, class Visitor>
bool visitRange(const PairBlocks& blocks, const BlockRange& range, const BodyRows& rows,
                const Visitor& visitor) {
  for (std::size_t i = range.first; i < range.last; ++i) {
    const PairBlock& block = blocks.blocks[i];
    const bool goes_on = forParts(block, [&](std::size_t, const BlockPart& part) HWY_ATTR {
      const std::uint32_t near = bitsOf(mayBeNearer(rows, part, visitor.reach())) & part.is_pair;
      return near == 0 || visitor.template visit<CoreOne, CoreRow>(rows, part, near);
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

void collectInLanes(const PairBlocks& blocks, const BodyRows& rows, double within,
                    std::vector<NearestPair>& near) {
  visitBlocks(blocks, rows, CollectNear{within, near});
}

void searchInLanes(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                   NearestPair& best) {
  visitBlocks(blocks, rows, FindNearest{passed, best});
}

void findContactInLanes(const PairBlocks& blocks, const BodyRows& rows,
                        const ContactDistances& limits, FoundContact& found) {
  visitBlocks(blocks, rows, FindContact{limits, found});
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(collectInLanes);
HWY_EXPORT(searchInLanes);
HWY_EXPORT(findContactInLanes);
}  // namespace

void findNear(const PairBlocks& blocks, const BodyRows& rows, double within,
              std::vector<NearestPair>& near) noexcept {
  near.clear();
  HWY_DYNAMIC_DISPATCH(collectInLanes)(blocks, rows, within, near);
}

void searchBlocks(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                  NearestPair& best) noexcept {
  HWY_DYNAMIC_DISPATCH(searchInLanes)(blocks, rows, passed, best);
}

void findContact(const PairBlocks& blocks, const BodyRows& rows, const ContactDistances& limits,
                 FoundContact& found) noexcept {
  HWY_DYNAMIC_DISPATCH(findContactInLanes)(blocks, rows, limits, found);
}

}  // namespace collision_monitor
#endif
