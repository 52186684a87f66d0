// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/publisher.h>
#include <ros/serialization.h>

namespace collision_monitor {

/// A message that is serialized already, for a topic of its type. roscpp serializes others while it
/// holds a lock that all publishers need; with a message of megabytes that takes longer than a
/// cycle.
struct PreparedMessage {
  ros::SerializedMessage bytes;
};

template <class Message>
PreparedMessage prepare(const Message& message) {
  return {ros::serialization::serializeMessage(message)};
}

}  // namespace collision_monitor

namespace ros {

namespace serialization {
template <>
inline SerializedMessage serializeMessage(const collision_monitor::PreparedMessage& message) {
  return message.bytes;
}
}  // namespace serialization

namespace message_traits {
/// "*": any type.
template <>
struct MD5Sum<collision_monitor::PreparedMessage> {
  static const char* value(const collision_monitor::PreparedMessage& /*message*/) { return "*"; }
};
template <>
struct DataType<collision_monitor::PreparedMessage> {
  static const char* value(const collision_monitor::PreparedMessage& /*message*/) { return "*"; }
};
}  // namespace message_traits

}  // namespace ros
