// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace collision_monitor::fit_tool {

/// Shows progress: a moving bar on a terminal, otherwise one line per step.
class Progress {
 public:
  Progress(std::FILE* stream, bool is_terminal) : stream_(stream), is_terminal_(is_terminal) {}

  /// Called before step `done` of `total`; `done` == `total` removes the bar.
  void show(const std::string& work, const std::string& name, std::size_t done,
            std::size_t total) const;

 private:
  std::FILE* stream_;
  bool is_terminal_;
};

/// "[=====-----]  5/10 fitting hand"
std::string barOf(const std::string& text, std::size_t done, std::size_t total);

}  // namespace collision_monitor::fit_tool
