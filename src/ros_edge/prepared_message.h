// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/publisher.h>
#include <ros/serialization.h>

namespace collision_monitor {

/// A message that is serialized. roscpp serializes others while it holds a lock that every
/// publisher needs: a message of megabytes on one thread would delay the cycle on another.
struct PreparedMessage {
  ros::SerializedMessage bytes;
};

}  // namespace collision_monitor

namespace ros {

namespace serialization {
template <>
inline SerializedMessage serializeMessage(const collision_monitor::PreparedMessage& message) {
  return message.bytes;
}
}  // namespace serialization

namespace message_traits {
/// "*": a message of any type.
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

namespace collision_monitor {

/// Publishes without a long lock. For threads other than the cycle's.
/// @pre Message is the type of the topic
template <class Message>
void publishPrepared(const ros::Publisher& publisher, const Message& message) {
  publisher.publish(PreparedMessage{ros::serialization::serializeMessage(message)});
}

}  // namespace collision_monitor
