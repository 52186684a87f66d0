// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "enums.h"

#include <array>

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

// As long as the process lives: a look-up takes longer than most calls. By number.
using Members = std::array<py::handle, 4>;
Members verdicts;
Members qualities;
Members path_states;

void find(const char* name, Members& members) {
  const py::object type = pythonClass("enums", name);
  for (std::size_t i = 0; i < members.size(); ++i) {
    members[i] = type(i).release();
  }
}

template <class Enum>
py::object memberOf(const Members& members, Enum value) {
  return py::reinterpret_borrow<py::object>(members[static_cast<std::size_t>(value)]);
}

}  // namespace

void findMembers() {
  find("Verdict", verdicts);
  find("Quality", qualities);
  find("PathState", path_states);
}

py::object member(Verdict verdict) { return memberOf(verdicts, verdict); }
py::object member(Quality quality) { return memberOf(qualities, quality); }
py::object member(ApproachState state) { return memberOf(path_states, state); }

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
