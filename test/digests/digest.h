// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor::test {

/// One number for many. Other bits most probably give another number.
/// Source: FNV-1a with 64 bits (Fowler, Noll, Vo; RFC 9923).
class Digest {
 public:
  std::uint64_t value() const { return value_; }

  /// Adds the bits of a number; all NaN are the same.
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  void add(Number number) {
    addBits(number == number ? number : std::numeric_limits<Number>::quiet_NaN());
  }

  template <class Enum, class = std::enable_if_t<std::is_enum_v<Enum>>, class = void>
  void add(Enum number) {
    addBits(static_cast<std::uint64_t>(number));
  }

  void add(const Eigen::Vector3d& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      addBits(vector[axis]);
    }
  }

  void add(const Pose& pose) {
    for (int column = 0; column < 3; ++column) {
      add(Eigen::Vector3d(pose.rotation.col(column)));
    }
    add(pose.translation);
  }

  void add(const Shape& shape) {
    add(shape.index());
    add(coreHalfExtents(shape));
    add(radiusOf(shape));
  }

  template <class Element>
  void add(const std::vector<Element>& elements) {
    add(elements.size());
    for (const Element& element : elements) {
      add(element);
    }
  }

 private:
  template <class Number>
  void addBits(Number number) {
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    for (const unsigned char byte : bytes) {
      value_ = (value_ ^ byte) * 0x100000001b3ULL;
    }
  }

  std::uint64_t value_{0xcbf29ce484222325ULL};
};

}  // namespace collision_monitor::test
