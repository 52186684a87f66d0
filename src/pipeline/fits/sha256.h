// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// The SHA-256 of bytes as 64 hexadecimal digits.
/// Source: FIPS 180-4, through OpenSSL.
/// @throws std::runtime_error if OpenSSL has disabled it.
std::string sha256(const std::string& bytes);

}  // namespace collision_monitor
