// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// SHA-256 of the bytes as 64 hexadecimal digits.
/// Source: FIPS 180-4, through OpenSSL.
/// @throws std::runtime_error where OpenSSL has it switched off.
std::string sha256(const std::string& bytes);

}  // namespace collision_monitor
