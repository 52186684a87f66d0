// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/second_opinion.h"

#include <utility>

#include "model/second_reader/second_reader.h"

namespace collision_monitor {
namespace {

void compareReaders(const MonitorSetup& setup, LogThread& log) noexcept {
  try {
    const std::vector<Problem> differences = askSecondReader(setup.descriptions, setup.setup.model);
    setup.later_warnings->add(differences);
    for (const Problem& difference : differences) {
      log.warn(toString(difference));
    }
  } catch (const std::exception& fault) {
    log.warn("no second opinion on the robots: " + failureText(fault));
  }
}

}  // namespace

SecondOpinion::~SecondOpinion() { wait(); }

void SecondOpinion::askFor(std::shared_ptr<const MonitorSetup> setup) noexcept {
  try {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (thread_.joinable()) {
      thread_.join();
    }
    thread_ = std::thread([setup = std::move(setup), &log = log_] { compareReaders(*setup, log); });
  } catch (const std::exception& fault) {
    log_.warn("no second opinion on the robots: " + failureText(fault));
  }
}

void SecondOpinion::wait() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (thread_.joinable()) {
    thread_.join();
  }
}

}  // namespace collision_monitor
