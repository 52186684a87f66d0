// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "enums.h"

#include "failures.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

static_assert(static_cast<int>(Verdict::clear) == 0 && static_cast<int>(Verdict::warning) == 1 &&
                  static_cast<int>(Verdict::unknown) == 2 &&
                  static_cast<int>(Verdict::contact) == 3,
              "as in collision_monitor_core/enums.py");
static_assert(static_cast<int>(Quality::exact) == 0 &&
                  static_cast<int>(Quality::lower_bound) == 1 &&
                  static_cast<int>(Quality::unknown) == 2 &&
                  static_cast<int>(Quality::estimate) == 3,
              "as in collision_monitor_core/enums.py");
static_assert(static_cast<int>(ApproachState::clear) == 0 &&
                  static_cast<int>(ApproachState::contact) == 1 &&
                  static_cast<int>(ApproachState::undecided) == 2 &&
                  static_cast<int>(ApproachState::unknown) == 3,
              "as in collision_monitor_core/enums.py");

template <class Enum>
py::object memberOf(const char* name, Enum value) {
  return pythonClass("enums", name)(static_cast<int>(value));
}

}  // namespace

py::object member(Verdict verdict) { return memberOf("Verdict", verdict); }
py::object member(Quality quality) { return memberOf("Quality", quality); }
py::object member(ApproachState state) { return memberOf("PathState", state); }

const char* nameOf(Verdict verdict) noexcept {
  constexpr const char* kNames[] = {"clear", "warning", "unknown", "contact"};
  return kNames[static_cast<std::size_t>(verdict)];
}

const char* nameOf(Quality quality) noexcept {
  constexpr const char* kNames[] = {"exact", "lower_bound", "unknown", "estimate"};
  return kNames[static_cast<std::size_t>(quality)];
}

const char* nameOf(ApproachState state) noexcept {
  constexpr const char* kNames[] = {"clear", "contact", "undecided", "unknown"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace collision_monitor::python
