// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "ros_edge/inputs/inputs.h"
#include "ros_edge/inputs/time_jumps.h"
#include "ros_edge/outputs/cycle_statistics.h"
#include "ros_edge/outputs/publishers.h"
#include "ros_edge/pace.h"
#include "ros_edge/services/enabling.h"

namespace collision_monitor {

/// Runs cycles on a thread of its own, by the timer or by new poses, and publishes. Wall time
/// paces it, so that it speaks also while a simulated clock stands still.
class CycleRunner {
 public:
  /// @pre the inputs outlive the runner.
  CycleRunner(const ros::NodeHandle& private_node, Inputs inputs,
              std::shared_ptr<const MonitorSetup> setup);
  ~CycleRunner();
  CycleRunner(const CycleRunner&) = delete;
  CycleRunner& operator=(const CycleRunner&) = delete;

  /// Takes the memory that watching a set-up needs.
  std::unique_ptr<Watch> makeWatch(std::shared_ptr<const MonitorSetup> setup) const;
  /// Watches that set-up from the next cycle on, for which it waits. The former watch ends here and
  /// not on the cycle's thread: to give its memory back takes longer than a cycle. Does not throw.
  void replaceWatch(std::unique_ptr<Watch> watch);
  std::shared_ptr<const MonitorSetup> currentSetup() const;
  void setEnabled(bool is_enabled);
  CycleStatistics& statistics() noexcept { return statistics_; }

 private:
  void run();
  void takeOverSetup();
  void handOver(Watch& former, Watch& next);
  void waitForNext();
  void runOnce();
  bool readPoses(const ros::Time& now);
  void publish(bool is_new);
  void summarize(const State& state);

  TransformStore& store_;
  JointStore& joints_;
  ClockWatch& clock_;
  Publishers publishers_;
  CycleStatistics statistics_;
  Enabling enabling_;

  mutable std::mutex mutex_;  ///< of the next five
  std::condition_variable taken_over_;
  std::shared_ptr<const MonitorSetup> current_;
  std::unique_ptr<Watch> next_;
  std::unique_ptr<Watch> former_;  ///< to be ended by who replaced it
  bool is_taking_over_{false};

  // Of the thread alone.
  std::unique_ptr<Watch> watch_;
  CycleFacts facts_;
  CyclePace pace_;
  SteadyClock::time_point last_summary_;
  std::uint64_t seen_data_{0};
  std::uint64_t seen_jumps_{0};
  TimeJumps jumps_;
  std::uint8_t last_level_{0};

  std::atomic<bool> is_running_{true};
  std::thread thread_;
};

}  // namespace collision_monitor
