// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/fit_parts.h"

namespace collision_monitor {

/// Fits as text, one shape or cut a line, closed by the hash of all before. Numbers are decimal and
/// read back to the same bits; the same in every locale.
std::string toText(const std::vector<Fit>& fits);

/// Nothing for text that is not whole, unchanged and of this version. What the numbers mean is
/// not looked at: provenExcess does.
std::optional<std::vector<Fit>> fitsFromText(const std::string& text);

}  // namespace collision_monitor
