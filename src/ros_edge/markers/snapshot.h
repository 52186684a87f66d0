// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "ros_edge/outputs/conversions.h"

namespace collision_monitor {

/// What markers show of a cycle: numbers and ids, so that the cycle's thread is done with it soon.
struct Snapshot {
  struct Link {
    Pose world_from_link;
    PartId part{kWorldPart};
    bool is_known{false};           ///< else there is no pose
    Verdict worst{Verdict::clear};  ///< of its pairs that are not unknown
  };
  struct Contact {
    PairId pair{0};
    ContactPoints points;
    Eigen::Vector3d normal_a_to_b;
  };
  struct Line {
    LinkPairIndex link_pair{0};
    Eigen::Vector3d point_on_a;
    Eigen::Vector3d point_on_b;
    Verdict verdict{Verdict::clear};
  };
  struct Label {
    LinkPairIndex link_pair{0};
    Eigen::Vector3d middle;  ///< between the closest points
    double distance{0.0};    ///< [m]
    Quality quality{Quality::exact};
  };

  std::shared_ptr<const MonitorSetup> fixed;
  std::int64_t stamp_ns{0};
  std::vector<Link> links;        ///< by LinkId
  std::vector<Contact> contacts;  ///< those of the topic `contacts`
  std::vector<Line> lines;        ///< of distances
  std::vector<Label> labels;      ///< of chooseLabelled, the most urgent first
};

/// @param snapshot keeps its memory
void takeSnapshot(const Watch& watch, Snapshot& snapshot);

}  // namespace collision_monitor
