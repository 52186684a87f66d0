// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot.h"

namespace collision_monitor::python {

std::unique_ptr<RobotQuery> Robot::take() const {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto query = std::move(idle_.back());
      idle_.pop_back();
      return query;
    }
  }
  return std::make_unique<RobotQuery>(monitor_);
}

void Robot::giveBack(std::unique_ptr<RobotQuery> query) const try {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(query));
} catch (const std::bad_alloc&) {
  // The next call makes a new one.
}

}  // namespace collision_monitor::python
