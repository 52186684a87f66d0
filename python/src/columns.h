// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <vector>

/// Columns of answers: arrays that view the memory of the object that owns the answers, without a
/// copy. They cannot be written to, and keep their owner alive.
namespace collision_monitor::python {

/// A number of C++ as numpy is to show it: enums and flags as numbers, indices so that kNone is -1.
template <class Field>
struct ShownAs {
  using Type = Field;
};
template <>
struct ShownAs<std::uint32_t> {
  using Type = std::int32_t;
};

namespace detail {

inline pybind11::array readOnly(pybind11::array array) {
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

template <class Field>
using Shown = typename ShownAs<Field>::Type;

}  // namespace detail

/// A field of each row, as an array of k numbers.
/// @param field takes a row to a reference to one of its numbers
template <class Row, class Field>
pybind11::array column(const std::vector<Row>& rows, const Field& field,
                       const pybind11::handle& owner) {
  using Number = std::decay_t<decltype(field(rows.front()))>;
  using Shown = std::conditional_t<std::is_enum_v<Number>, std::uint8_t, detail::Shown<Number>>;
  static_assert(sizeof(Number) == sizeof(Shown));
  const auto size = static_cast<pybind11::ssize_t>(rows.size());
  if (size == 0) {
    return detail::readOnly(pybind11::array_t<Shown>(0));
  }
  return detail::readOnly(pybind11::array(pybind11::dtype::of<Shown>(), {size},
                                          {static_cast<pybind11::ssize_t>(sizeof(Row))},
                                          static_cast<const void*>(&field(rows.front())), owner));
}

/// A point or direction of each row, as an array of k x 3 numbers.
template <class Row, class Field>
pybind11::array pointColumn(const std::vector<Row>& rows, const Field& field,
                            const pybind11::handle& owner) {
  const auto size = static_cast<pybind11::ssize_t>(rows.size());
  if (size == 0) {
    return detail::readOnly(pybind11::array_t<double>(std::vector<pybind11::ssize_t>{0, 3}));
  }
  return detail::readOnly(pybind11::array(
      pybind11::dtype::of<double>(), {size, pybind11::ssize_t{3}},
      {static_cast<pybind11::ssize_t>(sizeof(Row)), static_cast<pybind11::ssize_t>(sizeof(double))},
      static_cast<const void*>(field(rows.front()).data()), owner));
}

/// A copy of one point.
inline pybind11::array_t<double> pointArray(const Eigen::Vector3d& point) {
  return pybind11::array_t<double>(3, point.data());
}

}  // namespace collision_monitor::python
