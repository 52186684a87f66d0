// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace collision_monitor {

/// Of a node that publishes; PublisherId{} is one whose name is not known.
enum class PublisherId : std::uint32_t {};

/// Two publishers, or one twice, said different things of one time.
struct Contradiction {
  std::int64_t stamp_ns{0};  ///< 0: there was none
  PublisherId first{};
  PublisherId second{};
};

/// Whether what was said then is too near to what is newest to believe it.
/// @param newest_ns the newest stamp
/// @param max_age [s]
inline bool isRecent(const Contradiction& contradiction, std::int64_t newest_ns,
                     double max_age) noexcept {
  return contradiction.stamp_ns != 0 &&
         1e-9 * static_cast<double>(newest_ns - contradiction.stamp_ns) <= max_age;
}

/// Names of publishers by number, so that data need not carry names. The first 1000 names are kept:
/// nodes that come and go under ever new names do not fill the memory.
class PublisherNames {
 public:
  PublisherId idOf(const std::string& name);
  /// "" if it is not known.
  std::string nameOf(PublisherId id) const;

 private:
  std::vector<std::string> names_{""};
  std::unordered_map<std::string, PublisherId> ids_;
};

/// "'/a' and '/b' send", "'/a' sends" or "somebody sends".
std::string whoSends(const std::string& first, const std::string& second);

}  // namespace collision_monitor
