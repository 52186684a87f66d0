// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "collision_monitor/robot_query.h"

namespace collision_monitor::python {

/// A monitor, and queries that wait for the next call. Each call takes one for itself, so threads
/// of Python may share a robot; there are as many as threads have called at once.
class Robot {
 public:
  explicit Robot(RobotMonitor monitor) : monitor_(std::move(monitor)) {}

  const RobotMonitor& monitor() const noexcept { return monitor_; }
  std::string nameOfLink(LinkId link) const { return monitor_.model().link(link).name; }

  /// Calls `ask` with a query, without the GIL. `ask` touches nothing of Python.
  template <class Ask>
  auto ask(const Ask& ask) const {
    const pybind11::gil_scoped_release no_gil;
    Borrowed borrowed(*this);
    return ask(*borrowed.query);
  }

 private:
  struct Borrowed {
    explicit Borrowed(const Robot& its_robot) : robot(its_robot), query(robot.take()) {}
    ~Borrowed() { robot.giveBack(std::move(query)); }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;

    const Robot& robot;
    std::unique_ptr<RobotQuery> query;
  };

  std::unique_ptr<RobotQuery> take() const;
  void giveBack(std::unique_ptr<RobotQuery> query) const;

  RobotMonitor monitor_;
  mutable std::mutex mutex_;  ///< guards `idle_`
  mutable std::vector<std::unique_ptr<RobotQuery>> idle_;
};

using SharedRobot = std::shared_ptr<Robot>;

/// Add the classes and functions of their source files to the module.
void bindRobot(pybind11::module_& module);
void bindLoading(pybind11::module_& module);
void bindDistances(pybind11::module_& module);
void bindMany(pybind11::module_& module);
void bindSolids(pybind11::module_& module);

}  // namespace collision_monitor::python
