// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/helper_main.h"

#include <malloc.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <vector>

#include "model/mesh_loading/message_channel.h"

namespace collision_monitor {
namespace {

constexpr int kSocket = STDIN_FILENO;

void setLimit(__rlimit_resource resource, rlim_t limit) {
  rlimit both{};
  if (getrlimit(resource, &both) == 0) {
    // The hard limit stays, because the next question may have a higher limit.
    both.rlim_cur = std::min(limit, both.rlim_max);
    setrlimit(resource, &both);
  }
}

/// Closes files that the parent opened without O_CLOEXEC.
void closeOthers() {
  std::vector<int> descriptors;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
    descriptors.push_back(std::atoi(entry.path().filename().c_str()));
  }
  for (const int descriptor : descriptors) {
    if (descriptor > STDERR_FILENO) {
      close(descriptor);
    }
  }
}

void settle() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGINT, SIG_IGN);
  closeOthers();
  setLimit(RLIMIT_CORE, 0);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

/// [bytes] Address space of this process. A question's limit comes on top of the program's own.
rlim_t addressSpace() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

rlim_t usedSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
}

/// @param own [bytes] address space of the program before the first question
void limitQuestion(const Message& question, rlim_t own) {
  if (addressSpace() > own + question.terms.memory / 4) {
    malloc_trim(0);  // not each time: the next question needs much of it again
  }
  setLimit(RLIMIT_AS, own + question.text.size() + question.bytes.size() + question.terms.memory);
  // The parent enforces the time. This limit matters only if the parent is dead.
  setLimit(RLIMIT_CPU, usedSeconds() + question.terms.seconds + 1);
}

void waitForever(short events) {
  pollfd entry{kSocket, events, 0};
  poll(&entry, 1, -1);
}

std::string memory_answer;

/// Called by operator new. Its caller may be a library that cannot handle the failure.
[[noreturn]] void tellMemoryFault() {
  sendMessage(kSocket, {memory_answer, {}, {0, 0, 1}}, waitForever);
  _exit(EXIT_SUCCESS);
}

bool isStartedByUs() {
  struct stat status {};
  return fstat(kSocket, &status) == 0 && S_ISSOCK(status.st_mode);
}

Message answerOne(const AnswerQuestion& answer, const Message& question) {
  Message message;
  try {
    message.bytes = answer(question.text, question.bytes);
  } catch (const std::exception& fault) {
    message.text = fault.what();
    if (message.text.empty()) {
      message.text = "unknown fault";
    }
  }
  return message;
}

}  // namespace

int answerQuestions(const AnswerQuestion& answer, const TellMemoryFault& memory_fault) {
  if (!isStartedByUs()) {
    std::fputs("this program is started by others of its package, not by hand\n", stderr);
    return EXIT_FAILURE;
  }
  settle();
  const rlim_t own = addressSpace();
  for (;;) {
    Message question;
    setLimit(RLIMIT_AS, RLIM_INFINITY);
    if (!receiveMessage(kSocket, std::numeric_limits<std::uint64_t>::max(), waitForever,
                        question)) {
      return EXIT_SUCCESS;
    }
    limitQuestion(question, own);
    memory_answer = question.text + ": " + memory_fault(question.bytes, question.terms.memory);
    std::set_new_handler(tellMemoryFault);
    const Message reply = answerOne(answer, question);
    if (!sendMessage(kSocket, {reply.text, reply.bytes}, waitForever)) {
      return EXIT_SUCCESS;
    }
  }
}

}  // namespace collision_monitor
