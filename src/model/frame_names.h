// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// The prefix without slashes around it: "/left/" and "left" mean the same.
std::string trimmedPrefix(const std::string& tf_prefix);

/// "left/NAME" for the trimmed prefix "left"; a name that starts with "left/" is unchanged.
std::string prefixed(const std::string& trimmed_prefix, const std::string& name);

}  // namespace collision_monitor
