// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher.h>

#include <optional>

namespace collision_monitor {

/// Publishes a latched value. Late listeners get the last message, so without listeners only
/// changes are sent.
/// @param last as last sent
template <class Message, class Value>
void publishLatched(Value value, bool is_heard, const ros::Publisher& publisher,
                    std::optional<Value>& last) {
  if (last == value && !is_heard) {
    return;
  }
  last = value;
  Message message;
  message.data = value;
  publisher.publish(message);
}

}  // namespace collision_monitor
