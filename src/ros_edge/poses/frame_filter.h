// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace collision_monitor {

/// Which frames of tf are kept: those that a model names, and what is above them. Static transforms
/// of other frames come only once, so they are held back in case they turn out to be above. What is
/// above and what is held back is limited, so that no flood of frames fills the memory.
class FrameFilter {
 public:
  /// Wants these, too; before the first call every frame is wanted.
  void want(const std::vector<std::string>& frames);
  bool isWanted(const std::string& frame) const;
  /// A wanted frame has this parent, so it is wanted as well.
  void wantParent(const std::string& frame);

  /// Keeps a static transform of a frame that is not wanted yet.
  void holdBack(const geometry_msgs::TransformStamped& transform);
  /// Takes out the next held-back transform whose frame is wanted now.
  /// @return false if there is none.
  bool release(geometry_msgs::TransformStamped& transform);

  /// How many transforms of a message are too many: more than any tree that holds the frames.
  std::size_t mostTransforms() const;
  /// Frames that were refused because there were too many.
  std::uint64_t refusedCount() const { return refused_count_; }

 private:
  bool wants_all_{true};
  std::size_t told_count_{0};  ///< of those wanted, somebody asked for them
  std::unordered_set<std::string> wanted_;
  std::vector<std::string> newly_wanted_;  ///< whose transforms may be held back
  std::unordered_map<std::string, geometry_msgs::TransformStamped> held_back_;
  std::uint64_t refused_count_{0};
};

}  // namespace collision_monitor
