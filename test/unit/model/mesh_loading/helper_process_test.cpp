// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/helper_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "geometry/interruption.h"
#include "support/sanitizer.h"
#include "unit/model/mesh_files/mesh_file.h"

namespace collision_monitor::test {
namespace {

constexpr HelperLimits kWide{60.0, 1e9};

std::string askFaultOf(HelperProcess& helper, const std::string& name,
                       const HelperLimits& limits = kWide) {
  return messageOf([&] { helper.ask(name, "", limits); });
}

pid_t processOf(HelperProcess& helper) { return std::stoi(helper.ask("process", "", kWide)); }

std::size_t openFiles() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    count += entry.is_symlink() ? 1 : 0;
  }
  return count;
}

/// Waits, for a dying process is there a little longer. Its letter is that of /proc/PID/stat.
bool dies(pid_t process) {
  for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
       std::chrono::steady_clock::now() < end; std::this_thread::yield()) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string number;
    std::string name;
    std::string letter;
    if (!(status >> number >> name >> letter) || letter == "Z" || letter == "X") {
      return true;
    }
  }
  return false;
}

bool hasNoChild() { return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

TEST(HelperProcess, answersAsOftenAsItIsAsked_oneProcessForAll) {
  HelperProcess helper(UNRULY_HELPER);
  std::string large(30000000, 'x');
  for (std::size_t i = 0; i < large.size(); ++i) {
    large[i] = static_cast<char>(i % 251);
  }
  const pid_t process = processOf(helper);
  EXPECT_EQ(helper.ask("echo", "", kWide), "");
  EXPECT_TRUE(helper.ask("echo", large, kWide) == large);
  EXPECT_EQ(askFaultOf(helper, "refuse"), "refused");
  EXPECT_EQ(processOf(helper), process);
}

TEST(HelperProcess, deathsAreTold_theNextQuestionHasANewOne) {
  HelperProcess helper(UNRULY_HELPER);
  for (const auto& [name, cause] : {std::pair("crash", "crashed (Segmentation fault, signal 11)"),
                                    std::pair("abort", "crashed (Aborted, signal 6)"),
                                    std::pair("exit", "ended with exit code 7")}) {
    EXPECT_EQ(askFaultOf(helper, name), std::string(name) + ": the process that reads it " + cause);
    EXPECT_EQ(helper.ask("echo", "still here", kWide), "still here");
  }
  if (!isSanitized()) {
    EXPECT_EQ(askFaultOf(helper, "nest"),
              "nest: the process that reads it crashed (Segmentation fault, signal 11)");
  }
}

TEST(HelperProcess, whatTakesTooLong_isEnded) {
  HelperProcess helper(UNRULY_HELPER);
  const pid_t process = processOf(helper);
  for (const char* name : {"hang", "spin"}) {
    EXPECT_EQ(askFaultOf(helper, name, {0.05, 1e9}),
              std::string(name) + ": not read within the limit of 0.05 s");
  }
  EXPECT_TRUE(dies(process));
  EXPECT_EQ(helper.ask("echo", "still here", kWide), "still here");
}

TEST(HelperProcess, whatEatsTheMemory_isEnded_theNextMayHaveMore) {
  if (isSanitized()) {
    GTEST_SKIP() << "a sanitizer's memory";
  }
  HelperProcess helper(UNRULY_HELPER);
  EXPECT_EQ(askFaultOf(helper, "eat", {60.0, 1e8}), "eat: eats too much (100 MB)");
  const std::string large(200000000, 'x');
  EXPECT_TRUE(helper.ask("echo", large, {60.0, 1e9}) == large);
}

TEST(HelperProcess, whatIsNoMessage_isNone) {
  HelperProcess helper(UNRULY_HELPER);
  EXPECT_EQ(askFaultOf(helper, "garbage"),
            "garbage: the process that reads it crashed (Killed, signal 9)");
  EXPECT_EQ(helper.ask("echo", "still here", kWide), "still here");
}

TEST(HelperProcess, isInterrupted) {
  HelperProcess helper(UNRULY_HELPER);
  const pid_t process = processOf(helper);
  int looks = 0;
  const Interruptible interruptible([&] { return ++looks < 4; });
  EXPECT_THROW(helper.ask("hang", "", {600.0, 1e9}), Interrupted);
  EXPECT_TRUE(dies(process));
}

TEST(HelperProcess, leavesNoChildAndNoFile) {
  const std::size_t before = openFiles();
  {
    HelperProcess unused(UNRULY_HELPER);
    HelperProcess helper(UNRULY_HELPER);
    for (const char* name : {"crash", "echo", "crash", "exit", "echo"}) {
      askFaultOf(helper, name);
    }
    askFaultOf(helper, "hang", {0.05, 1e9});
    processOf(helper);
  }
  EXPECT_TRUE(hasNoChild());
  EXPECT_EQ(openFiles(), before);
}

TEST(HelperProcess, inheritsNoFile) {
  const int leaky = open("/dev/null", O_RDONLY);  // without O_CLOEXEC
  HelperProcess helper(UNRULY_HELPER);
  const std::string folder = "/proc/" + std::to_string(processOf(helper)) + "/fd/";
  EXPECT_TRUE(std::filesystem::is_symlink(folder + "0"));
  EXPECT_FALSE(std::filesystem::is_symlink(folder + std::to_string(leaky)));
  close(leaky);
}

TEST(HelperProcess, endsWithTheThreadThatStartedIt_thoughItHangs) {
  HelperProcess helper(UNRULY_HELPER);  // which does not end it, as where the whole program dies
  pid_t process = -1;
  std::thread([&] {
    process = processOf(helper);
    kill(process, SIGSTOP);
  }).join();
  EXPECT_TRUE(dies(process));
}

TEST(HelperProcess, isDeafToCtrlC) {
  HelperProcess helper(UNRULY_HELPER);
  const pid_t process = processOf(helper);
  kill(process, SIGINT);
  EXPECT_EQ(processOf(helper), process);
}

TEST(HelperProcess, programThatIsNotThere_isNamed) {
  HelperProcess helper("/nowhere/helper");
  EXPECT_EQ(askFaultOf(helper, "echo"),
            "the program '/nowhere/helper' cannot be started: No such file or directory");
}

TEST(HelperProcess, aHostThatWaitsForNoChild_isServed) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  {
    HelperProcess helper(UNRULY_HELPER);
    EXPECT_EQ(askFaultOf(helper, "exit"), "exit: the process that reads it ended");
    EXPECT_EQ(helper.ask("echo", "still here", kWide), "still here");
  }
  std::signal(SIGCHLD, before);
}

TEST(FindHelper, programsOfThePackage_areFound_othersAreNamed) {
  EXPECT_EQ(findHelper("read_meshes").filename(), "read_meshes");
  EXPECT_NE(messageOf([] {
              findHelper("no_such_helper");
            }).find("the program 'no_such_helper' of this package is not at '/"),
            std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::test
