// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/search_blocks.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "collision_monitor/pipeline/pair_blocks.h"
#include "narrow_phase/lanes_box_box-inl.h"
#include "narrow_phase/lanes_points-inl.h"
#include "narrow_phase/lanes_segment_box-inl.h"
#include "narrow_phase/plain_twin.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Lanes of a block that one vector holds.
struct BlockPart {
  const PairBlock& block;
  std::size_t lane;
  std::uint32_t is_pair;  ///< bit by lane of the vector
};

HWY_INLINE std::uint32_t bitsOf(Truth truth) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Lanes(), truth, bits);
  return bits[0];
}

template <class CoreOne, class CoreRow>
HWY_INLINE Number distanceOf(const CoreOne& one, const CoreRow& row) {
  Number distance;
  if constexpr (CoreOne::kKind <= CoreRow::kKind) {
    distance = coreDistance(one, row).distance;
  } else {
    distance = coreDistance(row, one).distance;
  }
  return hn::Sub(hn::Sub(distance, one.radius), row.radius);
}

/// Where bounding spheres leave a pair the chance to be as near as `best`.
HWY_INLINE Truth mayBeNearer(const BodyRows& rows, const BlockPart& part, double best) {
  const ShapeLanes row{rows.numbers.data() + part.block.first + part.lane, rows.stride};
  const OneShape one{rows.numbers.data() + part.block.one, rows.stride};
  const Vector3 between = vectorAt(row, column::center) - vectorAt(one, column::center);
  const Number radii = hn::Add(one.at(kBoundingColumn), row.at(kBoundingColumn));
  const Number allowed = hn::Add(radii, number(best));
  return hn::Not(hn::Gt(dot(between, between), hn::Mul(allowed, allowed)));
}

/// Calls `take` with the pair and its distance.
template <class CoreOne, class CoreRow, class Take>
HWY_INLINE void measurePart(const BodyRows& rows, const BlockPart& part, std::uint32_t which,
                            const Take& take) {
  const double* first_one = rows.numbers.data() + part.block.one;
  const double* first_row = rows.numbers.data() + part.block.first + part.lane;
  HWY_ALIGN double distances[hn::MaxLanes(Lanes())];
  hn::Store(distanceOf(CoreOne(OneShape{first_one, rows.stride}),
                       CoreRow(ShapeLanes{first_row, rows.stride})),
            Lanes(), distances);
  for (; which != 0; which &= which - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(which));
    if (HWY_UNLIKELY(!(distances[lane] == distances[lane]))) {
      const PosedCore one = readCore(CoreOne::kKind, first_one, rows.stride);
      const PosedCore row = readCore(CoreRow::kKind, first_row + lane, rows.stride);
      distances[lane] = plainDistance(one.core, one.pose, row.core, row.pose).distance;
    }
    take(part.block.pairs[part.lane + lane], distances[lane]);
  }
}

/// Every distance of a part.
struct MeasureAll {
  std::vector<double>& distances;

  template <class CoreOne, class CoreRow>
  HWY_INLINE void visit(const BodyRows& rows, const BlockPart& part) const {
    measurePart<CoreOne, CoreRow>(rows, part, part.is_pair,
                                  [&](PairId id, double distance)
                                      HWY_ATTR { distances[index(id)] = distance; });
  }
};

/// The nearest pair so far.
struct FindNearest {
  const PassedPairs& passed;
  NearestPair& best;

  template <class CoreOne, class CoreRow>
  HWY_INLINE void visit(const BodyRows& rows, const BlockPart& part) const {
    const std::uint32_t which = bitsOf(mayBeNearer(rows, part, best.distance)) & part.is_pair;
    if (which == 0) {
      return;
    }
    measurePart<CoreOne, CoreRow>(rows, part, which, [&](PairId id, double distance) HWY_ATTR {
      if (distance < best.distance && passed.is_passed[passed.group_of[index(id)]] == 0) {
        best = {id, distance};
      }
    });
  }
};

template <class CoreOne, class CoreRow, class Visitor>
void visitRange(const PairBlocks& blocks, const BlockRange& range, const BodyRows& rows,
                const Visitor& visitor) {
  constexpr std::size_t kLanes = hn::MaxLanes(Lanes());
  for (std::size_t i = range.first; i < range.last; ++i) {
    const PairBlock& block = blocks.blocks[i];
    for (std::size_t lane = 0; lane < kBlockLanes; lane += kLanes) {
      const std::uint32_t is_pair = (block.is_pair >> lane) & ((1U << kLanes) - 1U);
      if (is_pair != 0) {
        visitor.template visit<CoreOne, CoreRow>(rows, {block, lane, is_pair});
      }
    }
  }
}

template <class CoreOne, class Visitor>
void visitKind(const PairBlocks& blocks, const BlockRange& range, const BodyRows& rows,
               const Visitor& visitor) {
  switch (range.row) {
    case CoreKind::point:
      return visitRange<CoreOne, PointCore>(blocks, range, rows, visitor);
    case CoreKind::segment:
      return visitRange<CoreOne, SegmentCore>(blocks, range, rows, visitor);
    case CoreKind::box:
      return visitRange<CoreOne, BoxCore>(blocks, range, rows, visitor);
  }
}

template <class Visitor>
void visitBlocks(const PairBlocks& blocks, const BodyRows& rows, const Visitor& visitor) {
  for (const BlockRange& range : blocks.ranges) {
    switch (range.one) {
      case CoreKind::point:
        visitKind<PointCore>(blocks, range, rows, visitor);
        break;
      case CoreKind::segment:
        visitKind<SegmentCore>(blocks, range, rows, visitor);
        break;
      case CoreKind::box:
        visitKind<BoxCore>(blocks, range, rows, visitor);
        break;
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

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(measureInLanes);
HWY_EXPORT(searchInLanes);
}  // namespace

void measureBlocks(const PairBlocks& blocks, const BodyRows& rows,
                   std::vector<double>& distances) noexcept {
  HWY_DYNAMIC_DISPATCH(measureInLanes)(blocks, rows, distances);
}

void searchBlocks(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                  NearestPair& best) noexcept {
  HWY_DYNAMIC_DISPATCH(searchInLanes)(blocks, rows, passed, best);
}

}  // namespace collision_monitor
#endif
