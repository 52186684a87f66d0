// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ros_edge/poses/pose_reader.h"

/// The frames above a frame in tf. A fault may let them form a loop.
namespace collision_monitor {

/// "" for a frame without parent.
std::string PoseReader::parentOf(const std::string& frame) const {
  const auto place = places_.find(frame);
  return place == places_.end() ? "" : records_[place->second].parent;
}

/// The frame and those above it, up to `last` or to a frame without parent; empty if they form a
/// loop.
std::vector<std::string> PoseReader::chainUpTo(const std::string& last,
                                               const std::string& frame) const {
  std::vector<std::string> chain;
  for (std::string next = frame; !next.empty(); next = next == last ? "" : parentOf(next)) {
    // Only the last frame of a chain has no record. One more frame than that means a loop.
    if (chain.size() > records_.size()) {
      return {};
    }
    chain.push_back(next);
  }
  return chain;
}

/// As chainUpTo a frame without parent. In a loop, the frame that was sent last the longest ago
/// counts as one, if its data are stale: a message that was wrong once does no harm for ever.
std::vector<std::string> PoseReader::chainAbove(const std::string& frame) const {
  std::vector<std::string> chain = chainUpTo("", frame);
  if (!chain.empty()) {
    return chain;
  }
  std::size_t oldest = records_.size();
  for (const std::string& name : loopAbove(frame)) {
    const std::size_t place = places_.at(name);
    const bool is_older =
        oldest == records_.size() || records_[place].newest_ns < records_[oldest].newest_ns;
    oldest = isStale(place) && is_older ? place : oldest;
  }
  return oldest == records_.size() ? chain : chainUpTo(records_[oldest].name, frame);
}

/// Each frame of the loop once, beginning with the alphabetically first. @pre there is one
std::vector<std::string> PoseReader::loopAbove(const std::string& frame) const {
  std::string next = frame;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    next = parentOf(next);  // after as many steps as there are frames, `next` is in the loop
  }
  std::vector<std::string> loop;
  for (; loop.empty() || next != loop.front(); next = parentOf(next)) {
    loop.push_back(next);
  }
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

/// Whether a frame that moves was not sent for longer than a pose is believed.
bool PoseReader::isStale(std::size_t frame) const {
  const FrameRecord& record = records_[frame];
  return !record.is_static && 1e-9 * static_cast<double>(now_ns_ - record.newest_ns) > max_age_;
}

bool PoseReader::haveLoopsChanged() const {
  return std::any_of(loop_frames_.begin(), loop_frames_.end(), [&](const LoopFrame& frame) {
    return isStale(frame.record) != frame.was_stale;
  });
}

void PoseReader::noteLoop(const std::string& frame) {
  if (!chainUpTo("", frame).empty()) {
    return;
  }
  for (const std::string& name : loopAbove(frame)) {
    const std::size_t place = places_.at(name);
    const auto isThis = [&](const LoopFrame& noted) { return noted.record == place; };
    if (std::any_of(loop_frames_.begin(), loop_frames_.end(), isThis)) {
      return;  // another frame led to this loop
    }
    loop_frames_.push_back({place, isStale(place)});
  }
}

}  // namespace collision_monitor
