// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace collision_monitor {

/// The words between white space, as views of `text`, which must outlive them.
std::vector<std::string_view> wordsOf(std::string_view text);

/// Reads exactly numbers.size() finite numbers separated by white space, the same in every locale:
/// decimal point, optional sign and exponent.
///
/// @return what is wrong, as the end of a sentence ("'abc' is not a number", "2 numbers"); nothing
/// if all is well. `numbers` is written only in that case.
std::optional<std::string> parseNumbers(std::string_view text, Eigen::Ref<Eigen::VectorXd> numbers);

/// The shortest text that reads back as the same number, in every locale: "0.05", "-1e+17".
std::string shortText(double number);

}  // namespace collision_monitor
