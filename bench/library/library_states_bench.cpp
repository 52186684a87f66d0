// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times the library on states of a file, for figures that compare it with the Python module on the
// same states. The file holds plain doubles, state after state.
//   collision_monitor_library_states_bench distances|check ROBOT.urdf ROBOT.srdf FIT_CACHE STATES
// Prints the processor time of one state in microseconds, the median of five runs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "collision_monitor/robot_query.h"

namespace collision_monitor::test {
namespace {

/// [s] As Python's time.process_time.
double processTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> readStates(const char* file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  std::vector<double> numbers(static_cast<std::size_t>(stream.tellg()) / sizeof(double));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return numbers;
}

void answerAll(const std::string& call, RobotQuery& query, const std::vector<double>& states) {
  if (call == "check") {
    StatesRequest request;
    request.threads = 1;
    query.check(states, request);
    return;
  }
  const std::size_t n = query.monitor().model().variable_count;
  for (std::size_t first = 0; first < states.size(); first += n) {
    query.distances(Numbers(states.data() + first, n));
  }
}

void measure(char** given) {
  MonitorOptions options;
  options.fit_cache = given[3];
  RobotQuery query(RobotMonitor::fromFiles({{given[1], given[2]}}, options));
  const std::vector<double> states = readStates(given[4]);
  std::array<double, 5> times{};
  for (double& time : times) {
    const double start = processTime();
    answerAll(given[0], query, states);
    time = processTime() - start;
  }
  std::sort(times.begin(), times.end());
  const double count = static_cast<double>(states.size() / query.monitor().model().variable_count);
  std::printf("%.6g\n", 1e6 * times[2] / count);
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) try {
  if (argc != 6) {
    return 2;
  }
  collision_monitor::test::measure(argv + 1);
  return 0;
} catch (const std::exception& failure) {
  std::fprintf(stderr, "%s\n", failure.what());
  return 1;
}
