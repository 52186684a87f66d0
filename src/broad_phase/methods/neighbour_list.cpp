// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/neighbour_list.h"

#include <algorithm>
#include <cmath>

#include "broad_phase/box_tests.h"

namespace collision_monitor {
namespace {

/// A list that lasts fewer calls costs more than it saves.
constexpr float kLeastCalls = 2.0F;

SmallBox grownBy(float margin, const SmallBox& box) noexcept {
  SmallBox grown = box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grown.min[axis] -= margin;
    grown.max[axis] += margin;
  }
  return grown;
}

/// The greatest movement of a side of the box. Units: metres. 0 for infinite sides.
float motionOf(const SmallBox& before, const SmallBox& now) noexcept {
  float most = 0.0F;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // std::max in this order ignores NaN.
    most = std::max(most, std::abs(now.min[axis] - before.min[axis]));
    most = std::max(most, std::abs(now.max[axis] - before.max[axis]));
  }
  return most;
}

/// The mean side of a box. Units: metres. 0 if the box is infinite or empty.
float widthOf(const SmallBox& box) noexcept {
  const float sum = box.max[0] - box.min[0] + box.max[1] - box.min[1] + box.max[2] - box.min[2];
  return std::isfinite(sum) ? sum / 3.0F : 0.0F;
}

}  // namespace

NeighbourList::NeighbourList(std::size_t body_count)
    : sweep_(body_count), grown_(body_count, emptyBox()) {
  near_.reserve(roomForPairs(body_count));
  scratch_.reserve(roomForPairs(body_count));
}

bool NeighbourList::lasts(const std::vector<SmallBox>& boxes) const noexcept {
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    if (!isInside(boxes[body], grown_[body])) {
      return false;
    }
  }
  return true;
}

/// Let x be the margin and v the motion per call, both in box widths. A call costs v / x sweeps,
/// and tests of (1 + 2 x)^3 times as many pairs as meet. A sweep costs about six times these tests.
/// The sum is least where x (1 + 2 x) = sqrt(v).
float NeighbourList::marginFor(const std::vector<SmallBox>& boxes) const noexcept {
  float farthest = 0.0F;
  float widths = 0.0F;
  float count = 0.0F;
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    const float width = widthOf(boxes[body]);
    farthest = std::max(farthest, motionOf(grownBy(-margin_, grown_[body]), boxes[body]));
    widths += width;
    count += width > 0.0F ? 1.0F : 0.0F;
  }
  const float width = count > 0.0F ? widths / count : 0.0F;
  const float motion = farthest / static_cast<float>(calls_);
  if (!(width > 0.0F) || !(motion > 0.0F)) {
    return margin_;
  }
  const float margin = width * 0.25F * (std::sqrt(1.0F + 8.0F * std::sqrt(motion / width)) - 1.0F);
  return margin >= kLeastCalls * motion ? margin : 0.0F;
}

void NeighbourList::rebuild(const std::vector<SmallBox>& boxes) noexcept {
  margin_ = marginFor(boxes);
  calls_ = 0;
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    grown_[body] = grownBy(margin_, boxes[body]);
  }
  sweep_.findMeetings(grown_, near_);
  sortPairs(boxes.size(), near_, scratch_);
}

void NeighbourList::findMeetings(const std::vector<SmallBox>& boxes,
                                 std::vector<PairKey>& found) noexcept {
  ++calls_;
  if (!lasts(boxes)) {
    rebuild(boxes);
    if (margin_ == 0.0F) {
      found = near_;
      return;
    }
  }
  found.resize(near_.size());
  std::size_t count = 0;
  for (const PairKey pair : near_) {  // no branch: whether a near pair meets is hard to predict
    found[count] = pair;
    count += meets(boxes[lowerBody(pair)], boxes[upperBody(pair)]) ? 1 : 0;
  }
  found.resize(count);
}

}  // namespace collision_monitor
