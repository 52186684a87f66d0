// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// How robots that were missing are found and taken in. All but the first two may throw SetupError.
struct LateHooks {
  std::function<std::shared_ptr<const MonitorSetup>()> current_setup;
  /// loadLate
  std::function<LoadedRobots(const MonitorSetup& former, std::optional<std::size_t> only,
                             SetupReport& report)>
      find;
  /// buildLate
  std::function<std::shared_ptr<const MonitorSetup>(LoadedRobots come, const MonitorSetup& former,
                                                    SetupReport& report)>
      build;
  /// Watches what was built beside `former`; does nothing if other robots are watched by now.
  std::function<void(const MonitorSetup& late, const MonitorSetup& former)> take_in;
  /// withMissing
  std::function<void(const MonitorSetup& former, const std::vector<ListedRobot>& listed)>
      tell_missing;
  std::function<void(const std::string&)> log_error;
  GoesOn goes_on;
};

/// Takes in robots that have come, one by one if they cannot be taken in together. Robots that
/// cannot be taken in are built again when their descriptions change, or after a wait that grows to
/// a minute; where the rest of the set-up is in the way, when that changes. Until then State tells
/// why.
class LateRobots {
 public:
  explicit LateRobots(LateHooks hooks);

  /// To be called again and again, by one thread. Does not throw.
  void look();

 private:
  using Clock = std::chrono::steady_clock;

  /// What was last tried.
  struct Attempt {
    std::shared_ptr<const CycleSetup> beside;        ///< the robots that were there
    std::vector<std::string> texts;                  ///< URDFs and SRDFs of all
    std::shared_ptr<const MonitorSetup> late;        ///< null: they cannot even be built
    std::shared_ptr<const MonitorSetup> refused_by;  ///< the set-up that they do not fit to
    std::string fault;
    std::chrono::seconds wait{1};
    Clock::time_point again_at;
  };

  void lookAt(const std::shared_ptr<const MonitorSetup>& current);
  void attempt(LoadedRobots come, SetupReport& report,
               const std::shared_ptr<const MonitorSetup>& current);
  bool takeInOne(const std::vector<ListedRobot>& come, const MonitorSetup& current);
  void noteFault(const std::exception& fault);
  void tell(std::vector<ListedRobot> come, const MonitorSetup& current) const;

  LateHooks hooks_;
  Attempt last_;
  std::map<std::size_t, std::string> own_faults_;  ///< of robots tried alone, by ListedRobot
  std::string logged_;                             ///< fault
};

}  // namespace collision_monitor
