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

/// Selects the tf frames to keep: those that a model names, and those above them. Static transforms
/// come only once, so those of other frames are held back in case they turn out to be above. The
/// number of frames above and held back is limited, so a flood of frames cannot fill the memory.
class FrameFilter {
 public:
  /// Adds wanted frames. Before the first call every frame is wanted.
  void want(const std::vector<std::string>& frames);
  bool isWanted(const std::string& frame) const;
  /// Wants the parent of a wanted frame, too.
  void wantParent(const std::string& frame);

  /// Holds a static transform back whose frame is not wanted yet.
  void holdBack(const geometry_msgs::TransformStamped& transform);
  /// Takes out the next held-back transform whose frame has become wanted.
  /// @return false if there is none.
  bool release(geometry_msgs::TransformStamped& transform);

  /// Limit for the transforms of one message: more than any tree with these frames has.
  std::size_t mostTransforms() const;
  /// Number of frames refused because of the limit.
  std::uint64_t refusedCount() const { return refused_count_; }

 private:
  bool wants_all_{true};
  std::size_t told_count_{0};  ///< wanted frames that were named by want()
  std::unordered_set<std::string> wanted_;
  std::vector<std::string> newly_wanted_;  ///< their transforms may be held back
  std::unordered_map<std::string, geometry_msgs::TransformStamped> held_back_;
  std::uint64_t refused_count_{0};
};

}  // namespace collision_monitor
