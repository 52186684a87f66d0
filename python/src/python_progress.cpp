// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python_progress.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kMoment{50};

}  // namespace

bool PythonProgress::operator()(double done) {
  const auto now = std::chrono::steady_clock::now();
  if (failure_ || (done < 1.0 && now - last_ < kMoment)) {
    return !failure_;
  }
  last_ = now;
  const py::gil_scoped_acquire gil;
  try {
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
    if (!told_.is_none()) {
      told_(done);
    }
  } catch (const py::error_already_set&) {
    failure_ = std::current_exception();
  }
  return !failure_;
}

void PythonProgress::throwIfFailed() const {
  if (failure_) {
    std::rethrow_exception(failure_);
  }
}

}  // namespace collision_monitor::python
