// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

/// What calls of the library take, and how they refuse it.
namespace collision_monitor {

/// A view of numbers that stand in a row: of a vector, a list in braces, an Eigen vector or a plain
/// array. It holds no copy: use it as a parameter only.
class Numbers {
 public:
  Numbers() = default;
  /// `size` numbers that start at `data`.
  Numbers(const double* data, std::size_t size) noexcept : data_(data), size_(size) {}
  /// Numbers in braces, as in `query.verdict({0.1, 0.2})`.
  Numbers(std::initializer_list<double> list) noexcept : Numbers(list.begin(), list.size()) {}
  /// Anything with data() and size(), such as std::vector<double> or Eigen::VectorXd.
  template <class Row,
            class = decltype(static_cast<const double*>(static_cast<const Row*>(nullptr)->data()))>
  Numbers(const Row& row) noexcept  // NOLINT(google-explicit-constructor)
      : Numbers(row.data(), static_cast<std::size_t>(row.size())) {}

  /// The first number; may be null where there is none.
  const double* data() const noexcept { return data_; }
  const double* begin() const noexcept { return data_; }        ///< as data()
  const double* end() const noexcept { return data_ + size_; }  ///< behind the last number
  std::size_t size() const noexcept { return size_; }           ///< how many numbers there are
  double operator[](std::size_t i) const noexcept { return data_[i]; }  ///< @pre i < size()

 private:
  const double* data_{nullptr};
  std::size_t size_{0};
};

/// A call cannot be answered: an array of a wrong size, a joint that is not there, a number out of
/// range. Carries all faults; nothing has changed.
class ArgumentError : public std::invalid_argument {
 public:
  /// @param faults sentences; what() joins them, one a line.
  explicit ArgumentError(std::vector<std::string> faults);
  /// Sentences, at least one.
  const std::vector<std::string>& faults() const noexcept { return faults_; }

 private:
  std::vector<std::string> faults_;
};

}  // namespace collision_monitor
