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

/// Limits of one answer.
struct HelperLimits {
  double seconds{0.0};  ///< wall time
  double memory{0.0};   ///< [bytes] in addition to what the program has at its start
  const char* time_parameter{nullptr};  ///< the parameter that sets `seconds`, for messages
};

/// No answer, for a reason that is not the question's fault: the program is missing, or a limit
/// ended it.
struct HelperFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An answer took longer than its limit.
struct HelperTimeout : HelperFault {
  using HelperFault::HelperFault;
};

/// Runs a program of this package for work that could crash, hang or fill the memory, so that this
/// process survives (docs/decisions/helper-processes.md). helper_main.h is the other side.
///
/// Limits: for one thread, the one that starts it. The helper ends with that thread at the latest.
class HelperProcess {
 public:
  /// Starts nothing; the first question does.
  explicit HelperProcess(std::filesystem::path program);
  ~HelperProcess() { end(); }
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  /// Sends a name and bytes and waits for the answer. If a question kills the helper, the next
  /// question starts a new one.
  /// @throws HelperFault with a sentence: the limit that was exceeded, or why the helper cannot
  /// start; std::runtime_error: the helper's own error, or how it died.
  /// @throws Interrupted
  std::string ask(std::string_view name, std::string_view bytes, const HelperLimits& limits);

 private:
  void start();
  std::string end();

  std::filesystem::path program_;
  pid_t process_{-1};
  Descriptor socket_;
};

/// Path of a program of this package: beside the library or executable with this code, in the
/// program folders of build, devel and install spaces.
/// @throws HelperFault that names the places searched.
std::filesystem::path findHelper(const std::string& name);

}  // namespace collision_monitor
