// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>

#include "model/mesh_loading/helper_process.h"
#include "ros_edge/parameters/resource_loader.h"

namespace collision_monitor {

/// Fetches files from other computers. Starts nothing before the first file.
class Downloads {
 public:
  explicit Downloads(const LoadRules& rules) : rules_(rules) {}

  /// @throws std::runtime_error with a sentence: curl's error, too large, too slow; also for every
  /// further file of a server that was too slow once
  /// @throws Interrupted
  std::string load(const std::string& uri);

 private:
  LoadRules rules_;
  std::unique_ptr<HelperProcess> helper_;
  std::map<std::string, std::string> fault_of_;  ///< by server
};

}  // namespace collision_monitor
