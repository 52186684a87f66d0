// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <future>

#include "geometry/interruption.h"
#include "python_progress.h"

namespace collision_monitor::python {

/// Calls `work` without the GIL, and ends it with KeyboardInterrupt when the user presses Ctrl-C.
/// `work` has a thread of its own: only Python's main thread sees signals, and the library asks on
/// whichever thread it works. `work` touches nothing of Python.
/// @return what `work` returns
template <class Work>
auto runInterruptibly(const Work& work) {
  PythonProgress watch{pybind11::none()};
  std::atomic<bool> goes_on{true};
  // Without a policy, `work` runs below if the system has no more threads.
  auto answer = std::async([&] {
    const Interruptible interruptible([&] { return goes_on.load(); });
    return work();
  });
  {
    const pybind11::gil_scoped_release no_gil;
    while (answer.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout) {
      goes_on = watch(0.0);
    }
    answer.wait();
  }
  watch.throwIfFailed();
  return answer.get();
}

}  // namespace collision_monitor::python
