// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

namespace collision_monitor::fit_tool {

void Progress::show(const std::string& work, const std::string& name, std::size_t done,
                    std::size_t total) const {
  const bool is_over = done == total;
  if (is_terminal_) {
    // Goes back to the start of the line and clears it.
    std::fprintf(stream_, "\r\x1b[K%s",
                 is_over ? "" : barOf(work + " " + name, done, total).c_str());
  } else if (!is_over) {
    std::fprintf(stream_, "%s %s (%zu of %zu)\n", work.c_str(), name.c_str(), done + 1, total);
  }
  std::fflush(stream_);
}

std::string barOf(const std::string& text, std::size_t done, std::size_t total) {
  constexpr std::size_t kLength = 30;
  const std::size_t full = total == 0 ? kLength : kLength * done / total;
  const std::string all = std::to_string(total);
  const std::string part = std::to_string(done);
  return "[" + std::string(full, '=') + std::string(kLength - full, '-') + "] " +
         std::string(all.size() - part.size(), ' ') + part + "/" + all + " " + text;
}

}  // namespace collision_monitor::fit_tool
