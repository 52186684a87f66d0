// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/short_text.h"

#include <sstream>

namespace collision_monitor {

std::string shortText(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace collision_monitor
