// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/RobotState.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/answers/budget_use.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/pace.h"
#include "ros_edge/threads/inheriting_mutex.h"
#include "ros_edge/threads/real_time.h"
#include "ros_edge/watch.h"

namespace collision_monitor {

/// What /diagnostics reports about the last cycle; plain data, copied under a lock.
struct CycleSummary {
  std::uint8_t level{0};  ///< as in State
  std::string sentence;
  double age{0.0};              ///< [s]
  double time_to_contact{0.0};  ///< [s] as in State
  double speed_scale{0.0};      ///< as in State
  std::size_t pairs{0};
  std::size_t candidates{0};
  std::size_t measured{0};
  std::size_t refined{0};
  std::size_t left{0};
  std::size_t swept{0};
  double step{0.0};        ///< [s] as in State
  double step_limit{0.0};  ///< [s]
  double step_cap{0.0};    ///< [s]
  std::string step_warning;
  StepCount steps;
  std::uint64_t refused{0};  ///< input messages that were too long, and frames beyond the limit
  std::vector<std::string> unknown_links;
  std::vector<RobotState> robots;  ///< as in State
  std::size_t muted{0};            ///< as State::pairs_muted
  double muted_for{0.0};           ///< [s] as in State
};

/// Cycles since start.
struct CycleCounts {
  std::uint64_t cycles{0};
  std::uint64_t overruns{0};           ///< cycles among them that were late, as in State
  SteadyClock::time_point newest_end;  ///< end of the newest cycle; the start if there is none yet
  RealTimeState real_time{RealTimeState::off};  ///< of the cycle's thread now
};

/// Counts and times of cycles, and a summary of the last published one. The cycle's thread writes
/// them, the diagnostics thread reads them.
class CycleStatistics {
 public:
  /// Units: seconds.
  void addCycle(double cycle_time, bool is_overrun, RealTimeState real_time);
  void setSummary(CycleSummary summary);
  /// Starts a new set-up, whose work is added to `tally`; forgets budget use that was not taken.
  void startWork(const BudgetTally& tally);
  /// Adds the cycle that has just ended to `tally`; first clears `tally` if its use was taken.
  /// Neither allocates nor throws. @pre as addCycle of budget_use.h
  void addWork(const CycleBuffers& buffers, double cycle_time, BudgetTally& tally);

  struct Times {
    double median{0.0};
    double worst{0.0};
    std::size_t count{0};
  };
  /// Of the last cycles, at most 1024. Units: seconds.
  Times times() const;
  /// Up to now, however rarely states are published.
  CycleCounts counts() const;
  CycleSummary summary() const;
  /// Since it was last taken, or since the set-up changed.
  BudgetUse takeBudgetUse();

 private:
  static constexpr std::size_t kMemory = 1024;

  mutable InheritingMutex mutex_;
  std::array<double, kMemory> times_{};
  CycleCounts counts_{0, 0, SteadyClock::now()};
  CycleSummary summary_;
  BudgetUse budget_use_;
  bool is_use_taken_{false};
};

}  // namespace collision_monitor
