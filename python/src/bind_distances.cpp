// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include "columns.h"
#include "enums.h"
#include "failures.h"
#include "numbers.h"
#include "pair_answers.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

py::tuple linkNames(const Robot& robot, std::uint32_t pair) {
  const auto [link_a, link_b] = linksOf(robot, pair);
  return py::make_tuple(text(link_a), text(link_b));
}

py::object shapeName(const PairAnswer& answer, std::uint32_t shape) {
  const std::vector<EnclosingShape>& shapes = answer.robot->monitor().shapes();
  const bool is_known = answer.pair.quality != Quality::unknown && shape < shapes.size();
  return is_known ? py::object(text(shapes[shape].name)) : py::object(py::none());
}

void bindPair(py::module_& module) {
  py::class_<PairAnswer>(module, "PairDistance",
                         "The signed distance of two links. Frames: world. Units: metres.")
      .def_property_readonly(
          "links", [](const PairAnswer& self) { return linkNames(*self.robot, self.pair.pair); },
          "Names of link A and link B.")
      .def_property_readonly(
          "pair", [](const PairAnswer& self) { return self.pair.pair; }, "Index into Robot.pairs.")
      .def_property_readonly(
          "distance", [](const PairAnswer& self) { return self.pair.measured.distance; },
          "[m] > 0 apart, 0 touching, < 0 minus the depth of the overlap. NaN: unknown.")
      .def_property_readonly(
          "point_on_a",
          [](const PairAnswer& self) { return pointArray(self.pair.measured.point_on_a); },
          "(3,) [m] the nearest point of link A.")
      .def_property_readonly(
          "point_on_b",
          [](const PairAnswer& self) { return pointArray(self.pair.measured.point_on_b); },
          "(3,) [m] the nearest point of link B.")
      .def_property_readonly(
          "normal_a_to_b",
          [](const PairAnswer& self) { return pointArray(self.pair.measured.normal_a_to_b); },
          "(3,) Unit vector from A to B.")
      .def_property_readonly(
          "quality", [](const PairAnswer& self) { return member(self.pair.quality); }, "A Quality.")
      .def_property_readonly(
          "verdict", [](const PairAnswer& self) { return member(self.pair.verdict); },
          "A Verdict, by contact_distance and warning_distance.")
      .def_property_readonly(
          "is_refined", [](const PairAnswer& self) { return self.pair.is_refined; },
          "Measured between what the shapes enclose.")
      .def_property_readonly(
          "shape_a", [](const PairAnswer& self) { return shapeName(self, self.pair.shape_a); },
          "Name of the nearest shape of link A; None if the pair is unknown.")
      .def_property_readonly(
          "shape_b", [](const PairAnswer& self) { return shapeName(self, self.pair.shape_b); },
          "Name of the nearest shape of link B; None if the pair is unknown.")
      .def("__repr__", [](const PairAnswer& self) {
        return text("PairDistance " + pairText(*self.robot, self.pair));
      });
}

py::array contactPoints(const ContactAnswer& contact) {
  py::array_t<double> points({static_cast<py::ssize_t>(contact.points.size()), py::ssize_t{3}});
  for (std::size_t i = 0; i < contact.points.size(); ++i) {
    std::copy_n(contact.points[i].data(), 3, points.mutable_data() + 3 * i);
  }
  return std::move(points);
}

void bindContact(py::module_& module) {
  py::class_<ContactAnswer, PairAnswer>(module, "Contact", "Two links in contact, or unknown.")
      .def_property_readonly("points", contactPoints,
                             "(k, 3) [m] world frame, k <= 4: midway between the two surfaces. "
                             "k = 0 if the pair is unknown.")
      .def("__repr__", [](const ContactAnswer& self) {
        return text("Contact " + pairText(*self.robot, self.pair) + " in " +
                    countText(self.points.size(), "point"));
      });
}

/// Rows by distance, those that are unknown first.
std::vector<std::size_t> byDistance(const std::vector<MeasuredPair>& pairs) {
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    const double first = pairs[one].measured.distance;
    const double second = pairs[other].measured.distance;
    return std::isnan(first) ? !std::isnan(second) : first < second;
  });
  return order;
}

std::string distancesText(const DistancesAnswer& answer) {
  constexpr std::size_t kShown = 5;
  std::string lines = "Distances of " + countText(answer.pairs.size(), "pair");
  const std::vector<std::size_t> order = byDistance(answer.pairs);
  for (std::size_t i = 0; i < std::min(kShown, order.size()); ++i) {
    lines += "\n  " + pairText(*answer.robot, answer.pairs[order[i]]);
  }
  return lines + (order.size() > kShown ? "\n  ..." : "");
}

py::object gradientsOf(const py::object& self) {
  const auto& answer = self.cast<const DistancesAnswer&>();
  const auto n = static_cast<py::ssize_t>(answer.robot->monitor().model().variable_count);
  const auto rows = static_cast<py::ssize_t>(answer.pairs.size());
  if (!answer.has_gradients) {
    return py::none();
  }
  if (answer.gradients.empty()) {
    return detail::readOnly(py::array_t<double>({rows, n}));
  }
  return detail::readOnly(py::array(
      py::dtype::of<double>(), {rows, n},
      {n * static_cast<py::ssize_t>(sizeof(double)), static_cast<py::ssize_t>(sizeof(double))},
      static_cast<const void*>(answer.gradients.data()), self));
}

/// A property that views a field of all pairs.
template <class Field>
auto columnOf(const Field& field) {
  return [field](const py::object& self) {
    return column(self.cast<const DistancesAnswer&>().pairs, field, self);
  };
}

template <class Field>
auto pointsOf(const Field& field) {
  return [field](const py::object& self) {
    return pointColumn(self.cast<const DistancesAnswer&>().pairs, field, self);
  };
}

void addColumns(py::class_<DistancesAnswer>& type) {
  using Row = MeasuredPair;
  type.def_property_readonly("pair", columnOf([](const Row& row) -> auto& { return row.pair; }),
                             "(k,) int32: indices into Robot.pairs.")
      .def_property_readonly(
          "distance", columnOf([](const Row& row) -> auto& { return row.measured.distance; }),
          "(k,) [m] > 0 apart, 0 touching, < 0 minus the depth of the overlap. NaN: unknown.")
      .def_property_readonly(
          "point_on_a", pointsOf([](const Row& row) -> auto& { return row.measured.point_on_a; }),
          "(k, 3) [m] the nearest points of the links A.")
      .def_property_readonly(
          "point_on_b", pointsOf([](const Row& row) -> auto& { return row.measured.point_on_b; }),
          "(k, 3) [m] the nearest points of the links B.")
      .def_property_readonly("normal_a_to_b", pointsOf([](const Row& row) -> auto& {
                               return row.measured.normal_a_to_b;
                             }),
                             "(k, 3) Unit vectors from A to B.")
      .def_property_readonly("quality",
                             columnOf([](const Row& row) -> auto& { return row.quality; }),
                             "(k,) uint8: numbers of Quality.")
      .def_property_readonly("verdict",
                             columnOf([](const Row& row) -> auto& { return row.verdict; }),
                             "(k,) uint8: numbers of Verdict.")
      .def_property_readonly("is_refined",
                             columnOf([](const Row& row) -> auto& { return row.is_refined; }),
                             "(k,) bool: measured between what the shapes enclose.")
      .def_property_readonly("gradient", gradientsOf,
                             "(k, n) [m/rad] or [m/m] the derivative of each distance by the "
                             "velocity of each variable; None unless asked for.");
}

void bindDistancesAnswer(py::module_& module) {
  py::class_<DistancesAnswer> type(
      module, "Distances",
      "The signed distances of k pairs of links at one state. Frames: world. Units: metres.\n"
      "Its arrays view one block of memory and cannot be written to. A row is a PairDistance.");
  addColumns(type);
  type.def_property_readonly(
          "links",
          [](const DistancesAnswer& self) {
            py::list names;
            for (const MeasuredPair& pair : self.pairs) {
              names.append(linkNames(*self.robot, pair.pair));
            }
            return names;
          },
          "Names of link A and link B of each row.")
      .def(
          "sorted",
          [](const DistancesAnswer& self) {
            py::list rows;
            for (const std::size_t i : byDistance(self.pairs)) {
              rows.append(PairAnswer{self.robot, self.pairs[i]});
            }
            return rows;
          },
          "All rows, the nearest first; those that are unknown before all.")
      .def("__len__", [](const DistancesAnswer& self) { return self.pairs.size(); })
      .def("__getitem__",
           [](const DistancesAnswer& self, py::ssize_t i) {
             return PairAnswer{self.robot, self.pairs[indexIn(i, self.pairs.size())]};
           })
      .def("__repr__", [](const DistancesAnswer& self) { return text(distancesText(self)); });
}

}  // namespace

void bindDistances(py::module_& module) {
  bindPair(module);
  bindContact(module);
  bindDistancesAnswer(module);
}

}  // namespace collision_monitor::python
