// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "model/mesh_loading/helper_main.h"

namespace {

volatile bool reaches_cutoff = false;

/// Deeper than any stack, whatever the compiler makes of it.
int nestForEver() {
  volatile char filler[4096];
  filler[0] = 1;
  return reaches_cutoff ? 0 : nestForEver() + filler[0];
}

/// What may go wrong in a helper, by the name of the question.
std::string answer(const std::string& name, const std::string& bytes) {
  if (name == "crash") {
    std::raise(SIGSEGV);
  } else if (name == "nest") {
    return std::to_string(nestForEver());
  } else if (name == "abort") {
    std::abort();
  } else if (name == "exit") {
    _exit(7);
  } else if (name == "hang") {
    for (;;) {
      pause();
    }
  } else if (name == "spin") {
    for (volatile bool goes_on = true; goes_on;) {
    }
  } else if (name == "refuse") {
    throw std::runtime_error("refused");
  } else if (name == "eat") {
    std::vector<std::string> eaten;
    try {
      for (;;) {
        eaten.emplace_back(1 << 20, 'x');
      }
    } catch (...) {
      for (;;) {  // as a library may that takes no note of it
      }
    }
  } else if (name == "garbage") {
    const char garbage[64] = "garbage";
    write(STDIN_FILENO, garbage, sizeof garbage);
    pause();
  } else if (name == "process") {
    return std::to_string(getpid());
  }
  return bytes;
}

}  // namespace

/// A helper for tests of the other side.
int main() {
  return collision_monitor::answerQuestions(
      answer, [](const std::string& /*bytes*/, std::uint64_t limit) {
        return "eats too much (" + std::to_string(limit / 1000000) + " MB)";
      });
}
