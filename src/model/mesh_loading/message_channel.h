// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

/// Messages between this process and a helper on the same machine, over a stream socket: a header
/// in native byte order, then the text, then the bytes.
namespace collision_monitor {

/// The other contents of a message beside text and bytes.
struct MessageTerms {
  std::uint64_t memory{0};   ///< in questions: [bytes] limit for the answer
  std::uint64_t seconds{0};  ///< in questions: [s] limit of processor time
  std::uint64_t is_last{0};  ///< in answers: the helper ends after this one
};

struct Message {
  std::string text;
  std::string bytes;
  MessageTerms terms;
};

/// A message to be sent, without a copy of its bytes.
struct MessageView {
  std::string_view text;
  std::string_view bytes;
  MessageTerms terms{};
};

/// Called before each call that could block. Waits for the given poll events; throws to give up.
using WaitForPeer = std::function<void(short events)>;

/// @return false: the other side has closed.
/// @throws what `wait` does
bool sendMessage(int socket, const MessageView& message, const WaitForPeer& wait);

/// @param most [bytes] of text and bytes together; a longer message is refused
/// @return false: the other side has closed, or sent something other than such a message.
/// @throws what `wait` does; std::bad_alloc
bool receiveMessage(int socket, std::uint64_t most, const WaitForPeer& wait, Message& message);

}  // namespace collision_monitor
