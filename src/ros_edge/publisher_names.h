// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace collision_monitor {

/// Id of a publishing node; PublisherId{} stands for an unknown name.
enum class PublisherId : std::uint32_t {};

/// Two publishers, or one of them twice, sent different data for one time.
struct Contradiction {
  std::int64_t stamp_ns{0};  ///< 0: there was none
  PublisherId first{};
  PublisherId second{};
};

/// Whether the contradiction is too close to the newest data to trust them.
/// @param newest_ns the newest stamp
/// @param max_age [s]
inline bool isRecent(const Contradiction& contradiction, std::int64_t newest_ns,
                     double max_age) noexcept {
  return contradiction.stamp_ns != 0 &&
         1e-9 * static_cast<double>(newest_ns - contradiction.stamp_ns) <= max_age;
}

/// Names of publishers by number, so that data need not carry names. Only the first 1000 names are
/// kept, so nodes with ever new names cannot fill the memory.
class PublisherNames {
 public:
  PublisherId idOf(const std::string& name);
  /// "" if unknown.
  std::string nameOf(PublisherId id) const;

 private:
  std::vector<std::string> names_{""};
  std::unordered_map<std::string, PublisherId> ids_;
};

/// "'/a' and '/b' send", "'/a' sends" or "somebody sends".
std::string whoSends(const std::string& first, const std::string& second);

}  // namespace collision_monitor
