// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "several_robots.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <set>

#include "model/frame_names.h"

namespace collision_monitor::pairs_tool {
namespace {

struct NameAndValue {
  std::string name;
  std::string value;
};

NameAndValue splitAtEqual(const std::string& option, const std::string& text,
                          const std::string& accepted) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || equal + 1 == text.size()) {
    throw CLI::ValidationError(option + ": '" + text + "'; accepted: " + accepted);
  }
  return {trimmedPrefix(text.substr(0, equal)), text.substr(equal + 1)};
}

Place placeOf(const std::string& text) {
  const std::string accepted = "PREFIX=X,Y,Z or PREFIX=X,Y,Z,ROLL,PITCH,YAW in m and rad";
  const NameAndValue parts = splitAtEqual("--place", text, accepted);
  constexpr std::size_t kMost = 6;
  std::vector<double> numbers;
  const char* next = parts.value.c_str();
  bool is_number = true;
  while (is_number && numbers.size() <= kMost) {
    char* end = nullptr;
    numbers.push_back(std::strtod(next, &end));
    is_number = end != next && std::abs(numbers.back()) <= 1e6 && (*end == ',' || *end == '\0');
    if (!is_number || *end == '\0') {
      break;
    }
    next = end + 1;
  }
  if (!is_number || (numbers.size() != 3 && numbers.size() != kMost)) {
    throw CLI::ValidationError("--place: '" + text + "'; accepted: " + accepted +
                               ", each up to 1e6");
  }
  numbers.resize(kMost, 0.0);
  return {parts.name, {numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

}  // namespace

void addSeveralRobots(CLI::App& app, SeveralRobots& robots) {
  const char* const group = "Several robots";
  app.add_option("--prefix", robots.prefix, "of the first robot: its links become NAME/LINK")
      ->type_name("NAME")
      ->group(group);
  app.add_option_function<std::vector<std::string>>(
         "--with",
         [&robots](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             const NameAndValue parts = splitAtEqual("--with", text, "PREFIX=FILE");
             robots.others.push_back({parts.name, parts.value});
           }
         },
         "a further robot, as the monitor's parameter robots has it; may be given several times")
      ->allow_extra_args(false)
      ->type_name("PREFIX=FILE")
      ->group(group);
  app.add_option_function<std::vector<std::string>>(
         "--place",
         [&robots](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             robots.places.push_back(placeOf(text));
           }
         },
         "where the root of a robot stands: PREFIX=X,Y,Z or PREFIX=X,Y,Z,ROLL,PITCH,YAW\n"
         "in m and rad; an empty PREFIX is the first robot without one; default: 0,0,0;\n"
         "may be given several times")
      ->allow_extra_args(false)
      ->type_name("PLACE")
      ->group(group);
}

void checkSeveralRobots(const SeveralRobots& robots) {
  std::set<std::string> prefixes{trimmedPrefix(robots.prefix)};
  for (const OtherRobot& other : robots.others) {
    if (!prefixes.insert(other.prefix).second) {
      throw CLI::ValidationError("--with: two robots have the prefix '" + other.prefix + "'");
    }
  }
  std::set<std::string> placed;
  for (const Place& place : robots.places) {
    if (prefixes.count(place.prefix) == 0) {
      throw CLI::ValidationError("--place: no robot has the prefix '" + place.prefix + "'");
    }
    if (!placed.insert(place.prefix).second) {
      throw CLI::ValidationError("--place: two places for the prefix '" + place.prefix + "'");
    }
  }
}

}  // namespace collision_monitor::pairs_tool
