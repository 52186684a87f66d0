// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/frame_filter.h"

#include <algorithm>

namespace collision_monitor {
namespace {

/// Far more frames than above or beside any robot.
constexpr std::size_t kMostOthers = 10000;

}  // namespace

void FrameFilter::want(const std::vector<std::string>& frames) {
  wants_all_ = false;
  for (const std::string& frame : frames) {
    if (wanted_.insert(frame).second) {
      ++told_count_;
      newly_wanted_.push_back(frame);
    }
  }
}

bool FrameFilter::isWanted(const std::string& frame) const {
  return wants_all_ || wanted_.count(frame) != 0;
}

void FrameFilter::wantParent(const std::string& frame) {
  if (isWanted(frame)) {
    return;
  }
  if (wanted_.size() - told_count_ >= kMostOthers) {
    ++refused_count_;
    return;
  }
  wanted_.insert(frame);
  newly_wanted_.push_back(frame);
}

void FrameFilter::holdBack(const geometry_msgs::TransformStamped& transform) {
  const auto known = held_back_.find(transform.child_frame_id);
  if (known != held_back_.end()) {
    known->second = transform;
  } else if (held_back_.size() < kMostOthers) {
    held_back_.emplace(transform.child_frame_id, transform);
  } else {
    ++refused_count_;
  }
}

bool FrameFilter::release(geometry_msgs::TransformStamped& transform) {
  while (!newly_wanted_.empty()) {
    const auto held = held_back_.find(newly_wanted_.back());
    newly_wanted_.pop_back();
    if (held != held_back_.end()) {
      transform = std::move(held->second);
      held_back_.erase(held);
      return true;
    }
  }
  return false;
}

std::size_t FrameFilter::mostTransforms() const { return std::max(kMostOthers, 2 * told_count_); }

}  // namespace collision_monitor
