// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

/// Messages between this process and a helper on the same machine, over a stream socket: a
/// header in the order of the machine, then the text, then the bytes.
namespace collision_monitor {

/// What a message says beside its text and bytes.
struct MessageTerms {
  std::uint64_t memory{0};   ///< of questions: [bytes] that the answer may take
  std::uint64_t seconds{0};  ///< of questions: of processor time, likewise
  std::uint64_t is_last{0};  ///< of answers: the helper ends after this one
};

struct Message {
  std::string text;
  std::string bytes;
  MessageTerms terms;
};

/// What is to be sent, without a copy of its bytes.
struct MessageView {
  std::string_view text;
  std::string_view bytes;
  MessageTerms terms{};
};

/// Called before each call that could wait for the other side, with what poll is to wait for.
/// Throws to give up.
using WaitForPeer = std::function<void(short events)>;

/// @return false: the other side is gone.
/// @throws what `wait` does
bool sendMessage(int socket, const MessageView& message, const WaitForPeer& wait);

/// @param most [bytes] of text and bytes together; a message that says it is longer is none
/// @return false: the other side is gone, or sends what is no message of this program.
/// @throws what `wait` does; std::bad_alloc
bool receiveMessage(int socket, std::uint64_t most, const WaitForPeer& wait, Message& message);

}  // namespace collision_monitor
