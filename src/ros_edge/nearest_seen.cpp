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
    : records_(setup.checked.size()),
      variables_(setup.model.variable_count),
      newest_(makeNewestState(setup.model)),
      now_(variables_, kUnknown) {
  positions_.reserve(placesFor(setup) * variables_);  // touches no memory, which takes long
}

void NearestSeen::add(const CycleSetup& setup, const LinkPoses& poses, const JointReader& joints,
                      const CycleBuffers& buffers) noexcept {
  bool has_positions = false;
  const auto look = [&](const PairDistance& measured) {
    const LinkPairIndex pair = setup.link_pair_of[index(measured.pair)];
    Record& record = records_[pair];
    if (!(measured.measured.distance < record.distance) ||
        buffers.events.verdicts[pair] == Verdict::unknown) {
      return;
    }
    record.distance = measured.measured.distance;
    record.stamp_ns = poses.stamp_ns;
    record.place = record.place == kNone ? takePlace() : record.place;
    if (record.place != kNone) {
      if (!has_positions) {
        readPositions(setup, poses, joints);
        has_positions = true;
      }
      std::copy(now_.begin(), now_.end(),
                positions_.begin() + static_cast<std::ptrdiff_t>(record.place * variables_));
    }
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

std::uint32_t NearestSeen::takePlace() noexcept {
  const std::size_t size = (places_taken_ + 1) * variables_;
  if (size > positions_.capacity()) {
    return kNone;
  }
  positions_.resize(size);
  return places_taken_++;
}

void NearestSeen::touchRoomFor(std::size_t pairs) {
  positions_.resize(std::min(pairs * variables_, positions_.capacity()));
  positions_.clear();
}

void NearestSeen::inherit(const NearestSeen& former,
                          const std::vector<LinkPairIndex>& pair_of) noexcept {
  for (LinkPairIndex i = 0; i < pair_of.size(); ++i) {
    if (pair_of[i] == kNone) {
      continue;
    }
    Record& record = records_[i] = former.records_[pair_of[i]];
    const bool keeps_positions = record.place != kNone && variables_ == former.variables_;
    if (keeps_positions) {
      const auto first =
          former.positions_.begin() + static_cast<std::ptrdiff_t>(record.place * variables_);
      record.place = takePlace();
      if (record.place != kNone) {
        std::copy_n(first, variables_,
                    positions_.begin() + static_cast<std::ptrdiff_t>(record.place * variables_));
      }
    } else {
      record.place = kNone;
    }
  }
}

JointPositions NearestSeen::positionsOf(LinkPairIndex pair) const {
  if (records_[pair].place == kNone) {
    return {};
  }
  const auto first =
      positions_.begin() + static_cast<std::ptrdiff_t>(records_[pair].place * variables_);
  return {first, first + static_cast<std::ptrdiff_t>(variables_)};
}

}  // namespace collision_monitor
