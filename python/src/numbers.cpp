// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "numbers.h"

#include <cstdint>
#include <limits>

#include "collision_monitor/arguments.h"
#include "failures.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

[[noreturn]] void refuse(const std::string& name, const std::string& found,
                         const std::string& accepted) {
  throw ArgumentError({"`" + name + "` " + found + "; accepted: " + accepted});
}

std::string typeName(const py::handle& given) {
  return "is of type '" + std::string(Py_TYPE(given.ptr())->tp_name) + "'";
}

/// An array of numpy itself, whose data mean what they say.
bool isPlainArray(const py::handle& given) {
  return reinterpret_cast<PyObject*>(Py_TYPE(given.ptr())) ==
         reinterpret_cast<PyObject*>(py::detail::npy_api::get().PyArray_Type_);
}

/// Numbers of a masked array, NaN where they are masked; other objects as they are.
py::object unmasked(const py::object& given) {
  const auto numpy = py::module_::import("numpy");
  if (isPlainArray(given) || !py::isinstance(given, numpy.attr("ma").attr("MaskedArray"))) {
    return given;
  }
  return given.attr("astype")("float64").attr("filled")(std::numeric_limits<double>::quiet_NaN());
}

bool isAligned(const Array& array) {
  return reinterpret_cast<std::uintptr_t>(array.data()) % alignof(double) == 0;
}

Array convert(const py::object& given, const std::string& name, const std::string& accepted) try {
  const py::array any = py::array::ensure(unmasked(given));
  if (!any || std::string("biuf").find(any.dtype().kind()) == std::string::npos) {
    refuse(name, any ? "holds no numbers" : typeName(given), accepted);
  }
  const Array numbers = Array::ensure(any);
  if (!numbers) {
    refuse(name, typeName(given), accepted);
  }
  return isAligned(numbers) ? numbers : Array(numbers.attr("copy")());
} catch (const py::error_already_set&) {
  refuse(name, typeName(given), accepted);
}

/// The array itself, if it is rows of doubles already; else nothing.
Array asItIs(const py::object& given) {
  if (isPlainArray(given) && py::isinstance<Array>(given)) {
    auto array = py::reinterpret_borrow<Array>(given);
    if (isAligned(array)) {
      return array;
    }
  }
  return py::reinterpret_steal<Array>(py::handle());
}

std::vector<double> copied(const Array& array) {
  return {array.data(), array.data() + array.size()};
}

/// Positions of joints by name.
std::vector<double> readNamed(const RobotMonitor& monitor, const py::dict& given) {
  std::vector<std::string> joints;
  std::vector<double> positions;
  std::vector<std::string> faults;
  for (const auto& [key, value] : given) {
    const double position = PyFloat_AsDouble(value.ptr());
    const bool is_number = PyErr_Occurred() == nullptr;
    PyErr_Clear();
    if (!py::isinstance<py::str>(key)) {
      faults.push_back("the name of a joint " + typeName(key) + "; accepted: a str");
    } else if (!is_number) {
      faults.push_back("the position of joint '" + std::string(py::str(key)) + "' " +
                       typeName(value) + "; accepted: a number");
    } else {
      joints.push_back(py::cast<std::string>(key));
      positions.push_back(position);
    }
  }
  std::vector<double> state;
  try {
    state = monitor.stateOf(joints, positions);
  } catch (const ArgumentError& fault) {
    faults.insert(faults.end(), fault.faults().begin(), fault.faults().end());
  }
  if (!faults.empty()) {
    throw ArgumentError(std::move(faults));
  }
  return state;
}

/// Refuses lists of rows of different lengths, which numpy makes no array of.
void refuseRagged(const py::object& given, const std::string& name, std::size_t wanted,
                  const std::string& accepted) {
  if (!PyList_Check(given.ptr()) && !PyTuple_Check(given.ptr())) {
    return;
  }
  const auto lengthOf = [](const py::handle& row) {
    const bool is_row = PyList_Check(row.ptr()) || PyTuple_Check(row.ptr());
    return is_row ? py::len(row) : static_cast<std::size_t>(-1);
  };
  const auto rows = py::reinterpret_borrow<py::sequence>(given);
  std::size_t wrong = rows.size();
  bool is_ragged = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t length = lengthOf(rows[i]);
    if (length == static_cast<std::size_t>(-1)) {
      return;
    }
    wrong = wrong == rows.size() && length != wanted ? i : wrong;
    is_ragged = is_ragged || length != lengthOf(rows[0]);
  }
  if (is_ragged) {
    const std::size_t length = lengthOf(rows[wrong]);
    refuse(name + "[" + std::to_string(wrong) + "]", "has " + countText(length, "number"),
           accepted);
  }
}

Pose poseOf(const Array& matrix, const std::string& name) {
  Pose pose;
  for (py::ssize_t row = 0; row < 3; ++row) {
    for (py::ssize_t column = 0; column < 3; ++column) {
      pose.rotation(row, column) = matrix.at(row, column);
    }
    pose.translation[row] = matrix.at(row, 3);
  }
  if (matrix.at(3, 0) != 0.0 || matrix.at(3, 1) != 0.0 || matrix.at(3, 2) != 0.0 ||
      matrix.at(3, 3) != 1.0) {
    refuse(name, "does not end with the row 0, 0, 0, 1", "a matrix of a pose, 4 x 4");
  }
  return pose;
}

}  // namespace

Array readArray(const py::object& given, const std::string& name, const std::string& accepted) {
  const Array ready = asItIs(given);
  return ready ? ready : convert(given, name, accepted);
}

std::string shapeText(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

std::string countText(std::size_t count, const char* one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::vector<double> readState(const RobotMonitor& monitor, const py::object& given) {
  if (PyDict_Check(given.ptr())) {
    return readNamed(monitor, py::reinterpret_borrow<py::dict>(given));
  }
  const auto n = static_cast<py::ssize_t>(monitor.model().variable_count);
  if (const Array ready = asItIs(given); ready && ready.ndim() == 1 && ready.shape(0) == n) {
    return copied(ready);
  }
  const std::string accepted =
      std::to_string(n) + " numbers, one for each variable, or a dict of joint names";
  const Array array = readArray(given, "q", accepted);
  if (array.ndim() != 1 || array.shape(0) != n) {
    refuse("q", "has the shape " + shapeText(array), accepted);
  }
  return copied(array);
}

Array readRows(const RobotMonitor& monitor, const py::object& given, const char* name) {
  const auto n = static_cast<py::ssize_t>(monitor.model().variable_count);
  const std::string accepted = "rows of " + std::to_string(n) + " numbers";
  refuseRagged(given, name, monitor.model().variable_count, accepted);
  Array array = readArray(given, name, accepted);
  if (array.ndim() != 2 || array.shape(1) != n) {
    refuse(name, "has the shape " + shapeText(array), accepted);
  }
  return array;
}

Pose readPose(const py::object& given, const std::string& name) {
  if (given.is_none()) {
    return {};
  }
  const std::string accepted = "a matrix of a pose, 4 x 4; or a translation, 3 numbers; or None";
  const Array array = readArray(given, name, accepted);
  Pose pose;
  if (array.ndim() == 1 && array.shape(0) == 3) {
    pose.translation = Eigen::Vector3d(array.at(0), array.at(1), array.at(2));
  } else if (array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4) {
    pose = poseOf(array, name);
  } else {
    refuse(name, "has the shape " + shapeText(array), accepted);
  }
  return pose;
}

}  // namespace collision_monitor::python
