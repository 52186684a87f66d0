// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints what the library answers, number by number as 16 hexadecimal digits, for
// same_bytes_test.py. States are read from a file of plain doubles.
//   print_answers ROBOT.urdf ROBOT.srdf STATES
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <vector>

#include "collision_monitor/robot_query.h"

namespace collision_monitor {
namespace {

void print(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  std::printf("%016" PRIx64 "\n", bits);
}

template <class Enum>
void printCode(Enum code) {
  std::printf("%d\n", static_cast<int>(code));
}

void print(const Eigen::Vector3d& point) {
  for (const double number : point) {
    print(number);
  }
}

void print(const MeasuredPair& pair) {
  printCode(pair.pair);
  printCode(pair.quality);
  printCode(pair.verdict);
  printCode(pair.is_refined);
  print(pair.measured.distance);
  print(pair.measured.point_on_a);
  print(pair.measured.point_on_b);
  print(pair.measured.normal_a_to_b);
}

void print(const DistanceTable& table) {
  for (const MeasuredPair& pair : table.pairs) {
    print(pair);
  }
  for (const double number : table.gradients) {
    print(number);
  }
}

void printOne(RobotQuery& query, Numbers state) {
  constexpr double kWithin = 0.3;
  print(query.distances(state, {std::numeric_limits<double>::infinity(), true}));
  print(query.distances(state, {kWithin, false}));
  print(query.nearest(state));
  for (const TouchingPair& contact : query.contacts(state)) {
    print(contact.between);
    for (std::size_t i = 0; i < contact.point_count; ++i) {
      print(contact.points[i]);
    }
  }
  printCode(query.verdict(state));
  for (const Pose& pose : query.linkPoses(state)) {
    print(pose.translation);
  }
}

void printMany(RobotQuery& query, Numbers states) {
  for (const StateAnswer& answer : query.check(states)) {
    printCode(answer.verdict);
    printCode(answer.quality);
    printCode(static_cast<std::int32_t>(answer.pair));
    print(answer.distance);
  }
  WayPoints path;
  path.positions = states;
  const PathAnswer answer = query.checkPath(path);
  printCode(answer.verdict);
  for (const PairOnPath& pair : answer.pairs) {
    printCode(pair.state);
    print(pair.time);
    print(pair.at_least);
    print(pair.nearest.measured.distance);
  }
}

std::vector<double> readNumbers(const char* file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  std::vector<double> numbers(static_cast<std::size_t>(stream.tellg()) / sizeof(double));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return numbers;
}

void printAll(const char* urdf, const char* srdf, const char* file) {
  MonitorOptions options;
  options.fit_cache = "none";
  const RobotMonitor monitor = RobotMonitor::fromFiles({{urdf, srdf}}, options);
  RobotQuery query(monitor);
  const std::vector<double> states = readNumbers(file);
  const std::size_t n = monitor.model().variable_count;
  for (std::size_t first = 0; first < states.size(); first += n) {
    printOne(query, Numbers(states.data() + first, n));
  }
  printMany(query, states);
}

}  // namespace
}  // namespace collision_monitor

int main(int argc, char** argv) try {
  if (argc != 4) {
    return 2;
  }
  collision_monitor::printAll(argv[1], argv[2], argv[3]);
  return 0;
} catch (const std::exception& failure) {
  std::fprintf(stderr, "%s\n", failure.what());
  return 1;
}
