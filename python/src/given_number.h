// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>

/// Numbers that callers give alone. pybind11 would answer a wrong one with all arguments and
/// signatures; these name the argument.
namespace collision_monitor::python {

/// Anything, which a signature calls by the name of this Python type.
template <class Type>
struct Given {
  pybind11::object value;
};
using GivenNumber = Given<pybind11::float_>;
using GivenCount = Given<pybind11::int_>;

/// @param name of the argument, for messages
/// @throws ArgumentError if it is no number
double numberOf(const GivenNumber& number, const char* name);

/// @param most the largest that is accepted
/// @throws ArgumentError if it is no whole number from 0 to `most`
std::uint64_t countOf(const GivenCount& count, const char* name, std::uint64_t most);

}  // namespace collision_monitor::python

namespace pybind11::detail {

template <class Type>
struct type_caster<collision_monitor::python::Given<Type>> {
  PYBIND11_TYPE_CASTER(collision_monitor::python::Given<Type>, handle_type_name<Type>::name);
  bool load(handle source, bool /*converts*/) {
    value.value = reinterpret_borrow<object>(source);
    return true;
  }
};

}  // namespace pybind11::detail
