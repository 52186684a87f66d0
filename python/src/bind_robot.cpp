// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <limits>
#include <optional>

#include "enums.h"
#include "failures.h"
#include "given_number.h"
#include "many_answers.h"
#include "numbers.h"
#include "python_progress.h"
#include "robot_lists.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

DistancesAnswer distances(const SharedRobot& self, const py::object& q, const GivenNumber& within,
                          bool gradients) {
  const std::vector<double> state = readState(self->monitor(), q);
  const DistanceRequest request{numberOf(within, "within"), gradients};
  DistancesAnswer answer{self, {}, {}, gradients};
  self->ask([&](RobotQuery& query) {
    const DistanceTable& table = query.distances(state, request);
    answer.pairs = table.pairs;
    answer.gradients = table.gradients;
  });
  return answer;
}

py::object nearest(const SharedRobot& self, const py::object& q) {
  const std::vector<double> state = readState(self->monitor(), q);
  const MeasuredPair pair =
      self->ask([&](RobotQuery& query) -> MeasuredPair { return query.nearest(state); });
  return pair.pair == kNone ? py::object(py::none()) : py::cast(PairAnswer{self, pair});
}

py::list contacts(const SharedRobot& self, const py::object& q) {
  const std::vector<double> state = readState(self->monitor(), q);
  const std::vector<TouchingPair> found = self->ask(
      [&](RobotQuery& query) -> std::vector<TouchingPair> { return query.contacts(state); });
  py::list answers;
  for (const TouchingPair& contact : found) {
    ContactAnswer answer;
    answer.robot = self;
    answer.pair = contact.between;
    answer.points.assign(contact.points.begin(), contact.points.begin() + contact.point_count);
    answers.append(std::move(answer));
  }
  return answers;
}

py::object verdict(const SharedRobot& self, const py::object& q) {
  const std::vector<double> state = readState(self->monitor(), q);
  return member(self->ask([&](RobotQuery& query) { return query.verdict(state); }));
}

py::array_t<double> linkPoses(const SharedRobot& self, const py::object& q) {
  const std::vector<double> state = readState(self->monitor(), q);
  const std::vector<Pose> poses =
      self->ask([&](RobotQuery& query) -> std::vector<Pose> { return query.linkPoses(state); });
  py::array_t<double> matrices(
      {static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    writePose(poses[i], matrices.mutable_data() + 16 * i);
  }
  return matrices;
}

StateQuestion questionOf(const std::string& name) {
  if (name != "nearest" && name != "contact") {
    throw ArgumentError({"`question` is '" + name + "'; accepted: 'nearest', 'contact'"});
  }
  return name == "contact" ? StateQuestion::contact : StateQuestion::nearest;
}

Numbers numbersOf(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

StatesAnswer check(const SharedRobot& self, const py::object& states, const std::string& question,
                   const GivenCount& threads, const py::object& progress) {
  const Array rows = readRows(self->monitor(), states, "states");
  PythonProgress told(progress);
  constexpr std::uint64_t kMostThreads = std::numeric_limits<unsigned>::max();
  StatesRequest request{questionOf(question),
                        static_cast<unsigned>(countOf(threads, "threads", kMostThreads)),
                        [&](double done) { return told(done); }};
  StatesAnswer answer{self, {}};
  const auto count = static_cast<std::size_t>(rows.shape(0));
  if (count > 0) {
    answer.states =
        self->ask([&](RobotQuery& query) { return query.check(numbersOf(rows), request); });
  }
  told.throwIfFailed();
  if (rows.shape(1) == 0 && count > 0) {
    answer.states.resize(count, answer.states.front());  // without variables all are the same
  }
  return answer;
}

PathsAnswer checkPath(const SharedRobot& self, const py::object& positions, const py::object& times,
                      const py::object& velocities, const GivenNumber& margin,
                      const GivenNumber& resolution, const GivenNumber& tolerance,
                      const std::optional<GivenCount>& budget, const py::object& progress) {
  const Array rows = readRows(self->monitor(), positions, "positions");
  Array stamps;
  Array speeds;
  if (!times.is_none()) {
    stamps = readArray(times, "times", "one number for each way-point, or None");
  }
  if (!velocities.is_none()) {
    speeds = readRows(self->monitor(), velocities, "velocities");
  }
  PythonProgress told(progress);
  TrajectoryOptions options;
  options.margin = numberOf(margin, "margin");
  options.resolution = numberOf(resolution, "resolution");
  options.tolerance = numberOf(tolerance, "tolerance");
  options.progress = [&](double done) { return told(done); };
  options.budget = budget ? countOf(*budget, "budget", options.budget) : options.budget;
  const WayPoints path{numbersOf(rows), numbersOf(stamps), numbersOf(speeds)};
  PathsAnswer answer{self,
                     self->ask([&](RobotQuery& query) { return query.checkPath(path, options); })};
  told.throwIfFailed();
  return answer;
}

void addOneState(py::class_<Robot, SharedRobot>& type) {
  type.def(
          "state",
          [](const Robot& self, const py::object& q) {
            const std::vector<double> state = readState(self.monitor(), q);
            return py::array_t<double>(static_cast<py::ssize_t>(state.size()), state.data());
          },
          py::arg("q"),
          "The n numbers of a state.\n\n"
          "q: n numbers in the order of `variables`, or a dict of joint names: [rad] or [m]; "
          "joints that\nit leaves out are as in default_state. Every method takes it so.\n"
          "A number that is NaN or infinite is missing: what depends on it is unknown, never "
          "clear.\nRaises ArgumentError with all faults: a wrong shape, unknown joints.")
      .def("verdict", verdict, py::arg("q"),
           "The worst Verdict of all pairs at a state; unknown if q has a NaN.")
      .def("distances", distances, py::arg("q"),
           py::arg("within") = std::numeric_limits<double>::infinity(),
           py::arg("gradients") = false,
           "Distances of all pairs at a state, as exact geometry, with points and normals.\n\n"
           "within: [m] pairs that are farther apart are left out; unknown ones never.\n"
           "gradients: whether to compute the derivative of each distance by each variable.")
      .def("nearest", nearest, py::arg("q"),
           "The PairDistance of the nearest pair that is known, an unknown one if there is none;\n"
           "None if no pair is checked.")
      .def("contacts", contacts, py::arg("q"),
           "A list of Contacts: pairs in contact, and those that are unknown.")
      .def("link_poses", linkPoses, py::arg("q"),
           "(links, 4, 4) Poses of all links in the world frame, in the order of `links`; not "
           "finite where\nthey are unknown.")
      .def(
          "with_world",
          [](const py::object& self, const py::object& world) {
            return pythonClass("loading", "with_world")(self, world);
          },
          py::arg("world"),
          "The same robots with other objects beside them, as for another scene: a Robot. Nothing "
          "is read\nand fitted anew. world: as in load(); None: no objects.")
      .def(
          "plot",
          [](const py::object& self, const py::args& arguments, const py::kwargs& options) {
            return pythonClass("plot", "plot")(self, *arguments, **options);
          },
          "plot(q, within=0.2, count=10, axes=None): draws the robot's shapes at a state, and\n"
          "lines between the nearest points of the nearest pairs. Needs matplotlib. Returns the "
          "axes.");
}

void addManyStates(py::class_<Robot, SharedRobot>& type) {
  type.def("check", check, py::arg("states"), py::arg("question") = "nearest",
           py::arg("threads") = 0, py::arg("progress") = py::none(),
           "StateAnswers for many states, on all cores. The same for any number of threads.\n\n"
           "states: (m, n) rows of states.\n"
           "question: 'nearest', the nearest pair and the worst verdict; or 'contact', whether "
           "anything is\nin contact, which is faster.\n"
           "threads: at most; 0: one for each core.\n"
           "progress: a function of the share that is done. If it raises, the call ends with that.")
      .def("check_path", checkPath, py::arg("positions"), py::arg("times") = py::none(),
           py::arg("velocities") = py::none(), py::arg("margin") = TrajectoryOptions{}.margin,
           py::arg("resolution") = TrajectoryOptions{}.resolution,
           py::arg("tolerance") = TrajectoryOptions{}.tolerance, py::arg("budget") = py::none(),
           py::arg("progress") = py::none(),
           "Proves for all of a path whether links touch: a PathAnswer.\n\n"
           "positions: (m, n) way-points. Planar and floating joints must stay where they are.\n"
           "times: (m,) [s] increasing; None: 0, 1, 2, ...\n"
           "velocities: (m, n) joints move on cubics; None: straight from way-point to way-point.\n"
           "margin: [m] of pairs nearer than this, the nearest approach is searched for; 0: only\n"
           "contacts are, which is faster.\n"
           "resolution: [m] how much nearer than reported an approach may be.\n"
           "tolerance: [m] contact is up to contact_distance + tolerance.\n"
           "budget: a count of work after which the search ends as undecided; None: no end.\n"
           "progress: as in check.");
}

}  // namespace

void bindRobot(py::module_& module) {
  py::class_<Robot, SharedRobot> type(
      module, "Robot",
      "One or more robots, their shapes and the pairs to be checked; load() makes it.\n"
      "It never changes. Threads may share it: each call works on its own scratch, and frees the\n"
      "GIL. Earlier calls may change the last digits of distances, and depths that are estimates\n"
      "by more, except in check.\n"
      "Frames: world. Units: metres and radians.");
  addLists(type);
  addOneState(type);
  addManyStates(type);
}

}  // namespace collision_monitor::python
