// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/nearest_seen.h"

#include <algorithm>
#include <cmath>

#include "model/object_links.h"

namespace collision_monitor {
namespace {

/// Positions take at most 8 MB; the pairs that come first keep theirs.
constexpr std::size_t kMostNumbers = 1'000'000;

std::size_t placesFor(const CycleSetup& setup) {
  const std::size_t variables = std::max<std::size_t>(1, setup.model.variable_count);
  return std::min(setup.checked.size(), kMostNumbers / variables);
}

bool isOne(const Joint& joint) noexcept {
  return !joint.mimic &&
         (joint.type == JointType::revolute || joint.type == JointType::continuous ||
          joint.type == JointType::prismatic);
}

}  // namespace

NearestSeen::NearestSeen(const CycleSetup& setup)
    : record_of_(setup.checked.size(), kNone),
      variables_(setup.model.variable_count),
      newest_(makeNewestState(setup.model)),
      now_(variables_, kUnknown) {
  // Touches no memory, which takes long.
  records_.reserve(setup.checked.size());
  pairs_.reserve(setup.checked.size());
  positions_.reserve(placesFor(setup) * variables_);
}

void NearestSeen::add(const CycleSetup& setup, const LinkPoses& poses, const JointReader& joints,
                      CycleBuffers& buffers) noexcept {
  bool has_positions = false;
  const auto look = [&](const PairDistance& measured) {
    const LinkPairIndex pair = setup.link_pair_of[index(measured.pair)];
    if (!(measured.measured.distance < of(pair).distance) ||
        buffers.events.verdicts[pair] == Verdict::unknown) {
      return;
    }
    const std::uint32_t record = recordOf(pair);
    records_[record] = {measured.measured.distance, poses.stamp_ns, measured.quality};
    buffers.refine.told_below[pair] = measured.measured.distance;
    if (!has_positions) {
      readPositions(setup, poses, joints);
      has_positions = true;
    }
    keepPositions(record, now_.data());
  };
  for (const LinkPairIndex pair : buffers.events.active) {
    const std::uint32_t closest = buffers.events.closest[pair];
    if (closest != kNone) {
      look(buffers.distances.pairs[closest]);
    }
  }
  for (const PassedContact& passed : buffers.distances.passed) {
    look(passed.distance);
  }
}

void NearestSeen::readPositions(const CycleSetup& setup, const LinkPoses& poses,
                                const JointReader& joints) noexcept {
  for (const Robot& robot : setup.model.robots) {
    forOwnLinks(setup.model, robot, [&](std::size_t link) noexcept {
      newest_.poses.world_from_link[link] = poses.world_from_link[link];
      newest_.poses.status[link] = poses.status[link];
      newest_.poses.part[link] = poses.part[link];
    });
  }
  std::fill(now_.begin(), now_.end(), kUnknown);
  for (std::size_t i = 0; i < setup.model.joints.size(); ++i) {
    const Joint& joint = setup.model.joints[i];
    if (isOne(joint)) {
      const double told = joints.newest(joint.first_variable).position;
      const double target = std::isfinite(told) ? told : 0.0;
      now_[joint.first_variable] =
          newestPosition(setup.model, newest_, idAt<JointId>(i), target).value_or(told);
    }
  }
}

std::uint32_t NearestSeen::recordOf(LinkPairIndex pair) noexcept {
  if (record_of_[pair] == kNone) {
    record_of_[pair] = static_cast<std::uint32_t>(records_.size());
    records_.emplace_back();
    pairs_.push_back(pair);
    if (positions_.size() + variables_ <= positions_.capacity()) {
      positions_.resize(positions_.size() + variables_);
    }
  }
  return record_of_[pair];
}

bool NearestSeen::hasPositions(std::uint32_t record) const noexcept {
  return (record + std::size_t{1}) * variables_ <= positions_.size();
}

void NearestSeen::keepPositions(std::uint32_t record, const double* positions) noexcept {
  if (hasPositions(record)) {
    std::copy_n(positions, variables_, positions_.data() + record * variables_);
  }
}

void NearestSeen::touchRoomFor(std::size_t pairs) {
  records_.resize(std::min(pairs, records_.capacity()));
  records_.clear();
  pairs_.resize(std::min(pairs, pairs_.capacity()));
  pairs_.clear();
  positions_.resize(std::min(pairs * variables_, positions_.capacity()));
  positions_.clear();
}

void NearestSeen::inherit(const NearestSeen& former, const std::vector<LinkPairIndex>& pair_to,
                          RefineWork& refine) noexcept {
  std::fill(now_.begin(), now_.end(), kUnknown);
  for (std::uint32_t before = 0; before < former.records_.size(); ++before) {
    const LinkPairIndex pair = pair_to[former.pairs_[before]];
    if (pair != kNone) {
      const std::uint32_t record = recordOf(pair);
      records_[record] = former.records_[before];
      refine.told_below[pair] = records_[record].distance;
      const bool has_positions = variables_ == former.variables_ && former.hasPositions(before);
      keepPositions(record, has_positions ? former.positionsAt(before) : now_.data());
    }
  }
}

JointPositions NearestSeen::positionsOf(LinkPairIndex pair) const {
  const std::uint32_t record = record_of_[pair];
  if (record == kNone || !hasPositions(record)) {
    return {};
  }
  return {positionsAt(record), positionsAt(record) + variables_};
}

}  // namespace collision_monitor
