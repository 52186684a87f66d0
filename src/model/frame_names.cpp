// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/frame_names.h"

namespace collision_monitor {

std::string trimmedPrefix(const std::string& tf_prefix) {
  const std::size_t begin = tf_prefix.find_first_not_of('/');
  if (begin == std::string::npos) {
    return "";
  }
  return tf_prefix.substr(begin, tf_prefix.find_last_not_of('/') + 1 - begin);
}

std::string prefixed(const std::string& trimmed_prefix, const std::string& name) {
  const std::string front = trimmed_prefix + "/";
  if (trimmed_prefix.empty() || name.compare(0, front.size(), front) == 0) {
    return name;
  }
  return front + name;
}

}  // namespace collision_monitor
