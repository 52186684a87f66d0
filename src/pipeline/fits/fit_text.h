// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/fit_parts.h"

namespace collision_monitor {

/// Writes fits as text: one shape or cut on each line, then a hash of all before. Numbers are
/// decimal, read back to the same bits, and are the same in every locale.
std::string toText(const std::vector<Fit>& fits);

/// Reads fits; nothing if the text is incomplete, changed or of another version. Does not check the
/// meaning of numbers: provenExcess does.
std::optional<std::vector<Fit>> fitsFromText(const std::string& text);

}  // namespace collision_monitor
