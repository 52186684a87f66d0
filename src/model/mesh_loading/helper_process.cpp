// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/helper_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "geometry/interruption.h"
#include "model/mesh_loading/message_channel.h"
#include "model/number_text.h"

namespace collision_monitor {
namespace {

using Clock = std::chrono::steady_clock;

/// Waits for the socket until the deadline and looks for interruptions in between.
WaitForPeer waitForAnswer(int socket, std::string_view name, const HelperLimits& limits) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(limits.seconds));
  return [=](short events) {
    for (;;) {
      throwIfInterrupted();
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
      if (left.count() <= 0) {
        const char* const parameter = limits.time_parameter;
        throw HelperTimeout(
            std::string(name) + ": not read within the limit of " + shortText(limits.seconds) +
            " s" + (parameter == nullptr ? "" : std::string(" (parameter ") + parameter + ")"));
      }
      constexpr std::chrono::milliseconds kBetweenLooks(50);
      pollfd entry{socket, events, 0};
      if (poll(&entry, 1, static_cast<int>(std::min(left, kBetweenLooks).count())) > 0) {
        return;
      }
    }
  };
}

std::string causeOf(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return std::string("crashed (") + strsignal(signal) + ", signal " + std::to_string(signal) +
           ")";
  }
  return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

/// Attributes and actions of posix_spawn.
class SpawnPlan {
 public:
  /// The helper gets the socket as its standard input, no output, and no blocked signals.
  explicit SpawnPlan(int socket) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

[[noreturn]] void refuseStart(const std::filesystem::path& program, int error) {
  throw HelperFault("the program '" + program.string() + "' cannot be started: " +
                    std::error_code(error, std::generic_category()).message());
}

}  // namespace

HelperProcess::HelperProcess(std::filesystem::path program) : program_(std::move(program)) {}

void HelperProcess::start() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    refuseStart(program_, errno);
  }
  Descriptor ours(ends[0]);
  const Descriptor its(ends[1]);
  fcntl(ours.get(), F_SETFL, O_NONBLOCK);
  const SpawnPlan plan(its.get());
  std::string name = program_.string();
  char* arguments[] = {name.data(), nullptr};
  // Not fork: in a process with many threads, the child could call hardly anything.
  const int error =
      posix_spawn(&process_, name.c_str(), &plan.actions, &plan.attributes, arguments, environ);
  if (error != 0) {
    process_ = -1;
    refuseStart(program_, error);
  }
  socket_ = std::move(ours);
}

/// Kills the helper if it still runs.
/// @return how it ended.
std::string HelperProcess::end() {
  socket_.reset();
  if (process_ < 0) {
    return "";
  }
  const pid_t process = std::exchange(process_, -1);
  kill(process, SIGKILL);  // no effect if it is dead already
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(process, &status, 0);
  } while (ended < 0 && errno == EINTR);
  // The host program may wait for all children itself, or ignore them.
  return ended == process ? causeOf(status) : "ended";
}

std::string HelperProcess::ask(std::string_view name, std::string_view bytes,
                               const HelperLimits& limits) {
  throwIfInterrupted();
  if (process_ < 0) {
    start();
  }
  const auto memory = static_cast<std::uint64_t>(limits.memory);
  const auto seconds = static_cast<std::uint64_t>(std::ceil(limits.seconds));
  const WaitForPeer wait = waitForAnswer(socket_.get(), name, limits);
  Message answer;
  try {
    if (!sendMessage(socket_.get(), {name, bytes, {memory, seconds}}, wait) ||
        !receiveMessage(socket_.get(), memory, wait, answer)) {
      throw std::runtime_error(std::string(name) + ": the process that reads it " + end());
    }
  } catch (...) {
    end();  // half an answer must not be read as the answer to the next question
    throw;
  }
  if (answer.terms.is_last != 0) {
    end();
    throw HelperFault(answer.text);
  }
  if (!answer.text.empty()) {
    throw std::runtime_error(answer.text);
  }
  return std::move(answer.bytes);
}

}  // namespace collision_monitor
