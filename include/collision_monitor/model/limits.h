// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace collision_monitor {

/// Thresholds of the verdicts. Units: metres and seconds.
/// @pre finite; contact_distance <= warning_distance <= report_distance; hysteresis >= 0;
/// 0 <= contact_time <= warning_time; time_hysteresis >= 0.
struct Limits {
  double contact_distance{0.0};   ///< at or below: contact
  double warning_distance{0.05};  ///< at or below: warning
  double hysteresis{0.005};       ///< how far beyond its threshold a verdict is left
  double report_distance{0.2};    ///< pairs at or below are published
  double contact_time{0.0};       ///< a pair that touches this soon is a contact; 0: off
  double warning_time{0.1};       ///< a pair that touches this soon is a warning; 0: off
  double time_hysteresis{0.05};   ///< as hysteresis, for times
};

/// What readers and messages say about a field of Limits.
struct LimitField {
  const char* name;       ///< as in files and messages
  double Limits::*value;  ///< the field itself
  const char* unit;       ///< to stand behind a number: " m"
  double least;           ///< of what readers accept
  double greatest;        ///< likewise
};

/// Every field of Limits, in the order of the struct.
constexpr std::array<LimitField, 7> kLimitFields{{
    {"contact_distance", &Limits::contact_distance, " m", -1e6, 1e6},
    {"warning_distance", &Limits::warning_distance, " m", -1e6, 1e6},
    {"hysteresis", &Limits::hysteresis, " m", 0.0, 1e6},
    {"report_distance", &Limits::report_distance, " m", -1e6, 1e6},
    {"contact_time", &Limits::contact_time, " s", 0.0, 1e3},
    {"warning_time", &Limits::warning_time, " s", 0.0, 1e3},
    {"time_hysteresis", &Limits::time_hysteresis, " s", 0.0, 1e3},
}};

/// Some limits, by the order of kLimitFields; empty: as they were.
using LimitChanges = std::array<std::optional<double>, kLimitFields.size()>;

/// Sets the limits that are not empty.
inline void change(const LimitChanges& changes, Limits& limits) noexcept {
  for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
    double& value = limits.*kLimitFields[i].value;
    value = changes[i].value_or(value);
  }
}

}  // namespace collision_monitor
