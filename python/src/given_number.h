// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>

/// Numbers that callers give alone. pybind11 would answer a wrong one with all arguments and
/// signatures; these name the argument.
namespace collision_monitor::python {

/// Anything; a signature calls it float.
struct GivenNumber {
  pybind11::object given;
};

/// Anything; a signature calls it int.
struct GivenCount {
  pybind11::object given;
};

/// @param name of the argument, for messages
/// @throws ArgumentError if it is no number
double numberOf(const GivenNumber& number, const char* name);

/// @param most the largest that is accepted
/// @throws ArgumentError if it is no whole number from 0 to `most`
std::uint64_t countOf(const GivenCount& count, const char* name, std::uint64_t most);

}  // namespace collision_monitor::python

namespace pybind11::detail {

template <>
struct type_caster<collision_monitor::python::GivenNumber> {
  PYBIND11_TYPE_CASTER(collision_monitor::python::GivenNumber, const_name("float"));
  bool load(handle source, bool /*converts*/) {
    value.given = reinterpret_borrow<object>(source);
    return true;
  }
};

template <>
struct type_caster<collision_monitor::python::GivenCount> {
  PYBIND11_TYPE_CASTER(collision_monitor::python::GivenCount, const_name("int"));
  bool load(handle source, bool /*converts*/) {
    value.given = reinterpret_borrow<object>(source);
    return true;
  }
};

}  // namespace pybind11::detail
