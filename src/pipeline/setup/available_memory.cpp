// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "memory_need.h"

namespace collision_monitor {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t lessUsed(std::uint64_t limit, std::uint64_t used) {
  return limit == kUnlimited ? kUnlimited : limit - std::min(limit, used);
}

/// The number that a file holds; nothing if it holds a word, as "max", or does not exist.
std::optional<std::uint64_t> readNumber(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? std::optional<std::uint64_t>(number) : std::nullopt;
}

/// What the kernel counts as available without swapping.
std::uint64_t leftOfMachine() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  std::uint64_t kilobytes = 0;
  while (file >> word) {
    if (word == "MemAvailable:" && file >> kilobytes) {
      return 1024 * kilobytes;
    }
  }
  return kUnlimited;
}

/// What the control group leaves. A container sees its own group as the root.
std::uint64_t leftOfGroup() {
  const auto left = [](const std::string& most, const std::string& used) {
    const std::optional<std::uint64_t> limit = readNumber(most);
    return limit ? lessUsed(*limit, readNumber(used).value_or(0)) : kUnlimited;
  };
  const std::string root = "/sys/fs/cgroup/";
  return std::min(
      left(root + "memory.max", root + "memory.current"),
      left(root + "memory/memory.limit_in_bytes", root + "memory/memory.usage_in_bytes"));
}

/// What the limit of the address space leaves.
std::uint64_t leftOfProcess() {
  rlimit most{};
  if (getrlimit(RLIMIT_AS, &most) != 0 || most.rlim_cur == RLIM_INFINITY) {
    return kUnlimited;
  }
  const std::uint64_t pages = readNumber("/proc/self/statm").value_or(0);
  return lessUsed(most.rlim_cur, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::uint64_t availableMemory() {
  return std::min({leftOfMachine(), leftOfGroup(), leftOfProcess()});
}

}  // namespace collision_monitor
