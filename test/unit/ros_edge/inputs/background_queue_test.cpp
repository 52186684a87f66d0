// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/background_queue.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <boost/make_shared.hpp>
#include <functional>
#include <future>
#include <utility>

namespace collision_monitor::test {
namespace {

class Call : public ros::CallbackInterface {
 public:
  explicit Call(std::function<void()> work) : work_(std::move(work)) {}
  CallResult call() override {
    work_();
    return Success;
  }

 private:
  std::function<void()> work_;
};

TEST(BackgroundQueue, callbacks_yieldTheProcessor) {
  const int usual = getpriority(PRIO_PROCESS, 0);
  std::promise<int> nice;
  BackgroundQueue background;
  background.queue().addCallback(
      boost::make_shared<Call>([&] { nice.set_value(getpriority(PRIO_PROCESS, 0)); }));
  EXPECT_GT(nice.get_future().get(), usual);
  EXPECT_EQ(getpriority(PRIO_PROCESS, 0), usual) << "of this thread";
}

TEST(BackgroundQueue, callbacks_runOneAfterTheOther) {
  std::promise<void> may_end;
  std::shared_future<void> end = may_end.get_future().share();
  std::promise<void> has_begun;
  std::atomic<int> done{0};
  std::promise<int> done_before;
  BackgroundQueue background;
  background.queue().addCallback(boost::make_shared<Call>([&] {
    has_begun.set_value();
    end.wait();
    ++done;
  }));
  background.queue().addCallback(
      boost::make_shared<Call>([&] { done_before.set_value(done.load()); }));
  has_begun.get_future().wait();
  may_end.set_value();
  EXPECT_EQ(done_before.get_future().get(), 1);
}

TEST(BackgroundQueue, callbackAtItsEnd_isToldAndWaitedFor) {
  std::promise<void> has_begun;
  bool is_done = false;
  {
    BackgroundQueue background;
    background.queue().addCallback(boost::make_shared<Call>([&] {
      has_begun.set_value();
      while (!background.isEnding()) {
        std::this_thread::yield();
      }
      is_done = true;
    }));
    has_begun.get_future().wait();
  }
  EXPECT_TRUE(is_done);
}

}  // namespace
}  // namespace collision_monitor::test
