// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>

namespace collision_monitor::python {

/// What long calls without the GIL ask now and then: whether the user pressed Ctrl-C; and they tell
/// a function of Python how far they are.
class PythonProgress {
 public:
  /// @param told None, or a function of the share that is done
  explicit PythonProgress(pybind11::object told) : told_(std::move(told)) {}

  /// Does nothing if the last call was a moment ago.
  /// @return false after an exception of Python, which is kept
  bool operator()(double done);
  /// Throws the exception that is kept, if there is one. @pre the GIL is held
  void throwIfFailed() const;

 private:
  pybind11::object told_;
  std::exception_ptr failure_;
  std::chrono::steady_clock::time_point last_{std::chrono::steady_clock::now()};
};

}  // namespace collision_monitor::python
