// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "columns.h"
#include "enums.h"
#include "failures.h"
#include "many_answers.h"
#include "numbers.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

py::object stateAnswer(const StatesAnswer& self, py::ssize_t i) {
  const StateAnswer& answer = self.states[indexIn(i, self.states.size())];
  py::object links = py::none();
  if (answer.pair != kNone) {
    const auto [link_a, link_b] = linksOf(*self.robot, answer.pair);
    links = py::make_tuple(text(link_a), text(link_b));
  }
  return pythonClass("records", "StateAnswer")(member(answer.verdict), member(answer.quality),
                                               links, answer.distance);
}

std::string statesText(const StatesAnswer& answer) {
  std::array<std::size_t, 4> counts{};
  for (const StateAnswer& state : answer.states) {
    ++counts[static_cast<std::size_t>(state.verdict)];
  }
  std::string line = "StateAnswers of " + countText(answer.states.size(), "state");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    line +=
        (i == 0 ? ": " : ", ") + std::to_string(counts[i]) + " " + nameOf(static_cast<Verdict>(i));
  }
  return line;
}

void bindStates(py::module_& module) {
  using Row = StateAnswer;
  const auto view = [](const auto& field) {
    return [field](const py::object& self) {
      return column(self.cast<const StatesAnswer&>().states, field, self);
    };
  };
  py::class_<StatesAnswer>(
      module, "StateAnswers",
      "The answers for m states. Its arrays view one block of memory and cannot be written to.\n"
      "A row is a StateAnswer.")
      .def_property_readonly("verdict", view([](const Row& row) -> auto& { return row.verdict; }),
                             "(m,) uint8: numbers of Verdict.")
      .def_property_readonly("quality", view([](const Row& row) -> auto& { return row.quality; }),
                             "(m,) uint8: numbers of Quality, of the distance.")
      .def_property_readonly("pair", view([](const Row& row) -> auto& { return row.pair; }),
                             "(m,) int32: indices into Robot.pairs; -1 where there is none.")
      .def_property_readonly("distance", view([](const Row& row) -> auto& { return row.distance; }),
                             "(m,) [m] of that pair; a lower bound where it is far: see quality. "
                             "Overlaps are not measured. NaN without a pair.")
      .def("__len__", [](const StatesAnswer& self) { return self.states.size(); })
      .def("__getitem__", stateAnswer)
      .def("__repr__", [](const StatesAnswer& self) { return text(statesText(self)); });
}

std::string pathPairText(const PathPairAnswer& self) {
  const auto [link_a, link_b] = linksOf(*self.robot, self.pair.pair);
  std::string line = link_a + " - " + link_b + ": " + nameOf(self.state);
  if (self.state != ApproachState::unknown) {
    line += ", at least " + numberText(self.at_least) + " m";
  }
  if (self.state == ApproachState::contact || self.state == ApproachState::undecided) {
    line += (self.state == ApproachState::contact ? " before " : " until ") +
            numberText(self.time) + " s";
  }
  return line;
}

PathPairAnswer pathPair(const PathsAnswer& self, std::size_t i) {
  const PairOnPath& found = self.path.pairs[i];
  PathPairAnswer answer;
  answer.robot = self.robot;
  answer.pair = found.nearest;
  answer.pair.pair = static_cast<std::uint32_t>(i);
  answer.state = found.state;
  answer.time = found.time;
  answer.at_least = found.at_least;
  return answer;
}

void bindPathPair(py::module_& module) {
  py::class_<PathPairAnswer, PairAnswer>(
      module, "PairOnPath",
      "The approach of two links on a path. The fields of PairDistance are those of the nearest\n"
      "measurement; in contact, of the first contact.")
      .def_property_readonly(
          "state", [](const PathPairAnswer& self) { return member(self.state); }, "A PathState.")
      .def_readonly("time", &PathPairAnswer::time,
                    "[s] of the nearest measurement; undecided: until when the pair is clear.")
      .def_readonly("at_least", &PathPairAnswer::at_least,
                    "[m] Proven lower bound of the distance, until the contact if any.")
      .def("__repr__",
           [](const PathPairAnswer& self) { return text("PairOnPath " + pathPairText(self)); });
}

py::object firstContact(const PathsAnswer& self) {
  return self.path.first_contact == kNone ? py::object(py::none())
                                          : py::cast(pathPair(self, self.path.first_contact));
}

void bindPath(py::module_& module) {
  using Row = PairOnPath;
  const auto view = [](const auto& field) {
    return [field](const py::object& self) {
      return column(self.cast<const PathsAnswer&>().path.pairs, field, self);
    };
  };
  py::class_<PathsAnswer>(module, "PathAnswer",
                          "What is proven of a path, by pair of links, as in Robot.pairs. A row "
                          "is a PairOnPath.")
      .def_property_readonly(
          "verdict", [](const PathsAnswer& self) { return member(self.path.verdict); },
          "A Verdict; warning: a pair comes within the margin.")
      .def_property_readonly("first_contact", firstContact,
                             "The PairOnPath of the first contact, or None.")
      .def_property_readonly("state", view([](const Row& row) -> auto& { return row.state; }),
                             "(k,) uint8: numbers of PathState.")
      .def_property_readonly("time", view([](const Row& row) -> auto& { return row.time; }),
                             "(k,) [s] of the nearest measurements.")
      .def_property_readonly("at_least", view([](const Row& row) -> auto& { return row.at_least; }),
                             "(k,) [m] proven lower bounds of the distances, until a contact.")
      .def_property_readonly(
          "distance", view([](const Row& row) -> auto& { return row.nearest.measured.distance; }),
          "(k,) [m] of the nearest measurements.")
      .def("__len__", [](const PathsAnswer& self) { return self.path.pairs.size(); })
      .def("__getitem__",
           [](const PathsAnswer& self, py::ssize_t i) {
             return pathPair(self, indexIn(i, self.path.pairs.size()));
           })
      .def("__repr__", [](const PathsAnswer& self) {
        std::string line = std::string("PathAnswer: ") + nameOf(self.path.verdict);
        if (self.path.first_contact != kNone) {
          line += "; " + pathPairText(pathPair(self, self.path.first_contact));
        }
        return text(line);
      });
}

}  // namespace

void bindMany(py::module_& module) {
  bindStates(module);
  bindPathPair(module);
  bindPath(module);
}

}  // namespace collision_monitor::python
