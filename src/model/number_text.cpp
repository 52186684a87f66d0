// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

#include "model/visible_text.h"

namespace collision_monitor {
namespace {

std::optional<std::string> parseNumber(std::string_view word, double& number) {
  std::string_view digits = word;
  // from_chars does not accept the plus sign that XML allows.
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') {
    digits.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const std::string shown = "'" + asciiText(word.substr(0, 40)) + "'";
  if (error == std::errc::result_out_of_range) {
    return shown + " is out of range";
  }
  if (error != std::errc() || end != digits.data() + digits.size()) {
    return shown + " is not a number" +
           (isAscii(word) ? "" : " (numbers are written in ASCII, with its spaces between them)");
  }
  if (!std::isfinite(number)) {
    return shown + " is not finite";
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string_view> wordsOf(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\f\v";
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(kSpace); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kSpace, end);
  }
  return words;
}

std::optional<std::string> parseNumbers(std::string_view text,
                                        Eigen::Ref<Eigen::VectorXd> numbers) {
  const std::vector<std::string_view> words = wordsOf(text);
  Eigen::VectorXd read(numbers.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    double number = 0.0;
    if (auto fault = parseNumber(words[i], number)) {
      return fault;
    }
    if (i < static_cast<std::size_t>(read.size())) {
      read[static_cast<Eigen::Index>(i)] = number;
    }
  }
  if (words.size() != static_cast<std::size_t>(numbers.size())) {
    return std::to_string(words.size()) + (words.size() == 1 ? " number" : " numbers");
  }
  numbers = read;
  return std::nullopt;
}

std::string shortText(double number) {
  std::array<char, 32> digits{};
  // Without a precision, to_chars writes the fewest digits that identify the number.
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

}  // namespace collision_monitor
