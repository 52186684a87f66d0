// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/all_cores.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

/// Jobs that threads take one after another.
class Jobs {
 public:
  Jobs(std::size_t count, const std::function<void(std::size_t)>& work)
      : work_(work), faults_(count), goes_on_(goesOnHere()) {}

  /// Takes jobs until none is left.
  void doThem() {
    const Interruptible interruptible(goes_on_ ? GoesOn([this] { return goesOn(); }) : GoesOn());
    for (std::size_t job = next_++; job < faults_.size() && !is_interrupted_; job = next_++) {
      try {
        work_(job);
      } catch (const Interrupted&) {
        is_interrupted_ = true;
      } catch (...) {
        faults_[job] = std::current_exception();
      }
    }
  }

  void throwFault() const {
    if (is_interrupted_) {
      throw Interrupted();
    }
    for (const std::exception_ptr& fault : faults_) {
      if (fault) {
        std::rethrow_exception(fault);
      }
    }
  }

 private:
  bool goesOn() {
    const std::lock_guard<std::mutex> lock(asking_);
    if (!is_interrupted_ && !goes_on_()) {
      is_interrupted_ = true;
    }
    return !is_interrupted_;
  }

  const std::function<void(std::size_t)>& work_;
  std::vector<std::exception_ptr> faults_;  ///< by job
  GoesOn goes_on_;
  std::mutex asking_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> is_interrupted_{false};
};

}  // namespace

void forEachOnAllCores(std::size_t count, const std::function<void(std::size_t)>& work) {
  Jobs jobs(count, work);
  // Asking for the number of cores takes as long as a small job.
  const std::size_t cores = count < 2 ? 1 : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < std::min(cores, count)) {
      others.emplace_back([&jobs] { jobs.doThem(); });
    }
  } catch (const std::system_error&) {
    // The system gives no more threads. Those that exist do all jobs.
  }
  jobs.doThem();
  for (std::thread& other : others) {
    other.join();
  }
  jobs.throwFault();
}

void doBoth(bool at_once, const std::function<void()>& one, const std::function<void()>& other) {
  if (at_once) {
    forEachOnAllCores(2, [&](std::size_t i) { i == 0 ? one() : other(); });
  } else {
    one();
    other();
  }
}

}  // namespace collision_monitor
