// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/message_channel.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/types.h>

#include <algorithm>
#include <cerrno>

namespace collision_monitor {
namespace {

/// Marks this message layout. It reveals an old helper of another version.
constexpr std::uint64_t kMark = 0x636d5f6d73670001;

struct Header {
  std::uint64_t mark{kMark};
  std::uint64_t text_size{0};
  std::uint64_t bytes_size{0};
  MessageTerms terms;
};

bool isToBeTriedAgain() { return errno == EINTR || errno == EAGAIN; }

bool sendAll(int socket, const char* data, std::size_t size, const WaitForPeer& wait) {
  while (size > 0) {
    wait(POLLOUT);
    // Otherwise a dead helper would end this process by SIGPIPE.
    const ssize_t count = send(socket, data, size, MSG_NOSIGNAL);
    if (count < 0 && !isToBeTriedAgain()) {
      return false;
    }
    const auto sent = static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    data += sent;
    size -= sent;
  }
  return true;
}

bool receiveAll(int socket, char* data, std::size_t size, const WaitForPeer& wait) {
  while (size > 0) {
    wait(POLLIN);
    const ssize_t count = recv(socket, data, size, 0);
    if (count == 0 || (count < 0 && !isToBeTriedAgain())) {
      return false;
    }
    const auto received = static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    data += received;
    size -= received;
  }
  return true;
}

}  // namespace

bool sendMessage(int socket, const MessageView& message, const WaitForPeer& wait) {
  Header header;
  header.text_size = message.text.size();
  header.bytes_size = message.bytes.size();
  header.terms = message.terms;
  return sendAll(socket, reinterpret_cast<const char*>(&header), sizeof header, wait) &&
         sendAll(socket, message.text.data(), message.text.size(), wait) &&
         sendAll(socket, message.bytes.data(), message.bytes.size(), wait);
}

bool receiveMessage(int socket, std::uint64_t most, const WaitForPeer& wait, Message& message) {
  Header header;
  if (!receiveAll(socket, reinterpret_cast<char*>(&header), sizeof header, wait) ||
      header.mark != kMark || header.text_size > most ||
      header.bytes_size > most - header.text_size) {
    return false;
  }
  message.terms = header.terms;
  message.text.resize(header.text_size);
  message.bytes.resize(header.bytes_size);
  return receiveAll(socket, message.text.data(), message.text.size(), wait) &&
         receiveAll(socket, message.bytes.data(), message.bytes.size(), wait);
}

}  // namespace collision_monitor
