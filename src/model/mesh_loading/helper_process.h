// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model/descriptor.h"

namespace collision_monitor {

/// What one answer of a helper may take.
struct HelperLimits {
  double seconds{0.0};                  ///< of wall time
  double memory{0.0};                   ///< [bytes] beyond what the program has when it starts
  const char* time_parameter{nullptr};  ///< that sets `seconds`, for messages
};

/// That there is no answer says nothing against what was asked: the program is not there, or a
/// limit ended it.
struct HelperFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An answer took longer than its limit.
struct HelperTimeout : HelperFault {
  using HelperFault::HelperFault;
};

/// A program of this package that does what could crash, hang or fill the memory, so that this
/// process survives it (docs/decisions/helper-processes.md). Its other side is helper_main.h.
///
/// Limits: for one thread, the one that starts it: the helper ends with that thread at the latest.
class HelperProcess {
 public:
  /// Nothing runs before the first question.
  explicit HelperProcess(std::filesystem::path program);
  ~HelperProcess() { end(); }
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  /// Sends a name and bytes, and waits for the answer. After a question that killed its helper the
  /// next one has a new helper.
  /// @throws HelperFault with a sentence: the limit that it met, or why it cannot be started;
  /// std::runtime_error: what the helper says, or how it died.
  /// @throws Interrupted
  std::string ask(std::string_view name, std::string_view bytes, const HelperLimits& limits);

 private:
  void start();
  std::string end();

  std::filesystem::path program_;
  pid_t process_{-1};
  Descriptor socket_;
};

/// Where a program of this package is: beside the library or the executable that holds this code,
/// in the folders that builds, devel and install spaces have for programs.
/// @throws HelperFault that names the places where it was looked for.
std::filesystem::path findHelper(const std::string& name);

}  // namespace collision_monitor
