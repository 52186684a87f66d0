// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <string>
#include <vector>

namespace collision_monitor {

/// Adds "unknown link 1", "unknown link 2", ...: with equal keys, readers would see only the last.
inline void addNumbered(const std::string& key, const std::vector<std::string>& values,
                        diagnostic_updater::DiagnosticStatusWrapper& status) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    status.add(key + " " + std::to_string(i + 1), values[i]);
  }
}

}  // namespace collision_monitor
