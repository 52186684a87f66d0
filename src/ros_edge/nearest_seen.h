// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/poses/joint_reader.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// How near checked links have been. For the cycle's thread.
class NearestSeen {
 public:
  struct Record {
    double distance{std::numeric_limits<double>::infinity()};  ///< [m] infinity: never measured
    std::int64_t stamp_ns{0};
    Quality quality{Quality::unknown};
  };

  explicit NearestSeen(const CycleSetup& setup);

  /// Keeps the distances of a cycle that are the least so far, and the positions of joints then.
  /// Positions follow from the poses; joint states tell whole turns.
  /// The next cycles measure whatever comes nearer still.
  void add(const CycleSetup& setup, const LinkPoses& poses, const JointReader& joints,
           CycleBuffers& buffers) noexcept;

  /// Touches the memory that records of some pairs will take: a first touch takes long.
  /// @pre nothing was added
  void touchRoomFor(std::size_t pairs);

  /// Takes over what another one has of pairs that both check.
  /// @param pair_to as in CarryPlan
  void inherit(const NearestSeen& former, const std::vector<LinkPairIndex>& pair_to,
               RefineWork& refine) noexcept;

  Record of(LinkPairIndex pair) const noexcept {
    return record_of_[pair] == kNone ? Record() : records_[record_of_[pair]];
  }
  /// By variable, NaN where not known; empty if they were not kept.
  JointPositions positionsOf(LinkPairIndex pair) const;

 private:
  void readPositions(const CycleSetup& setup, const LinkPoses& poses,
                     const JointReader& joints) noexcept;
  /// The record of a pair, a new one if it has none.
  std::uint32_t recordOf(LinkPairIndex pair) noexcept;
  bool hasPositions(std::uint32_t record) const noexcept;
  /// @pre hasPositions(record)
  const double* positionsAt(std::uint32_t record) const noexcept {
    return positions_.data() + record * variables_;
  }
  void keepPositions(std::uint32_t record, const double* positions) noexcept;

  std::vector<std::uint32_t> record_of_;  ///< by LinkPairIndex, or kNone
  std::vector<Record> records_;           ///< of pairs that were measured, with room for all
  std::vector<LinkPairIndex> pairs_;      ///< by record
  JointPositions positions_;              ///< by record, then by variable; of the first records
  std::size_t variables_;
  NewestState newest_;  ///< scratch: the poses of a cycle, and no joint states
  JointPositions now_;  ///< scratch, by variable
};

}  // namespace collision_monitor
