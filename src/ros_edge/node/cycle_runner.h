// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ros_edge/inputs/inputs.h"
#include "ros_edge/inputs/time_jumps.h"
#include "ros_edge/outputs/cycle_statistics.h"
#include "ros_edge/outputs/pair_view.h"
#include "ros_edge/outputs/publishers.h"
#include "ros_edge/pace.h"
#include "ros_edge/services/enabling.h"
#include "ros_edge/threads/inheriting_mutex.h"
#include "ros_edge/threads/log_thread.h"
#include "ros_edge/threads/network_priority.h"
#include "ros_edge/threads/real_time.h"

namespace collision_monitor {

/// Runs cycles on its own thread, by timer or by new poses, and publishes. It is paced by wall
/// time, so it still publishes while a simulated clock stands still.
class CycleRunner {
 public:
  /// @pre the inputs and the log outlive the runner.
  CycleRunner(const ros::NodeHandle& private_node, Inputs inputs,
              std::shared_ptr<const MonitorSetup> setup, LogThread& log);
  ~CycleRunner();
  CycleRunner(const CycleRunner&) = delete;
  CycleRunner& operator=(const CycleRunner&) = delete;

  /// Allocates everything needed to watch a set-up, and prepares what the first cycle needs.
  std::unique_ptr<Watch> makeWatch(std::shared_ptr<const MonitorSetup> setup) const;
  /// Watches the new set-up from the next cycle on, and waits until it is taken over, between two
  /// cycles. The former watch is destroyed in this call, not on the cycle's thread, because freeing
  /// its memory takes longer than a cycle. Does not throw.
  void replaceWatch(std::unique_ptr<Watch> watch);
  std::shared_ptr<const MonitorSetup> currentSetup() const;
  /// What the next cycle knows of two links; nothing if no cycle ends within two seconds.
  std::optional<PairView> viewPair(const std::string& link_a, const std::string& link_b);
  void setEnabled(bool is_enabled);
  /// Of roscpp's network thread, as asked for. Any thread may call it.
  int networkPriority() const noexcept { return network_priority_.wanted(); }
  CycleStatistics& statistics() noexcept { return statistics_; }

 private:
  void run();
  void takeOverSetup();
  void handOver(Watch& former, Watch& next);
  void waitForNext();
  void runOnce();
  void endCycle();
  bool readPoses(const ros::Time& now);
  void publish(bool is_new);
  void summarize(const State& state);
  bool awaitViews();
  void answerViews();

  ros::NodeHandle private_node_;
  TransformStore& store_;
  JointStore& joints_;
  ClockWatch& clock_;
  LogThread& log_;
  Publishers publishers_;
  CycleStatistics statistics_;
  Enabling enabling_;

  /// Two links of which a caller wants to know.
  struct ViewRequest {
    std::string link_a;
    std::string link_b;
    bool is_awaited{false};  ///< a cycle has begun that tells all distances
    std::optional<PairView> view;
  };

  mutable InheritingMutex mutex_;  ///< guards the next nine
  std::vector<std::shared_ptr<ViewRequest>> view_requests_;
  std::condition_variable viewed_;
  std::condition_variable has_next_;
  std::condition_variable taken_over_;
  std::shared_ptr<const MonitorSetup> current_;
  std::unique_ptr<Watch> next_;
  std::shared_ptr<RobotTopics> topics_;  ///< of the newest set-up
  std::unique_ptr<Watch> former_;        ///< destroyed by the caller that replaced it
  bool is_taking_over_{false};

  // Used by the thread only.
  std::unique_ptr<Watch> watch_;
  CycleFacts facts_;
  CyclePace pace_;
  RealTime real_time_;
  NetworkPriority network_priority_;
  SteadyClock::time_point last_summary_;
  std::uint64_t seen_data_{0};
  std::uint64_t seen_jumps_{0};
  TimeJumps jumps_;
  std::uint8_t last_level_{0};

  std::atomic<bool> is_running_{true};
  std::thread thread_;
};

}  // namespace collision_monitor
