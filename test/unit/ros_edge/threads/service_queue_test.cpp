// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/service_queue.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <functional>
#include <future>
#include <thread>
#include <utility>

#include "ros_edge/threads/real_time.h"

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

int noPriority() { return 0; }

TEST(ServiceQueue, callbacks_yieldTheProcessor) {
  const int usual = getpriority(PRIO_PROCESS, 0);
  std::promise<int> nice;
  ServiceQueue queue(1, 10, noPriority);
  queue.queue().addCallback(
      boost::make_shared<Call>([&] { nice.set_value(getpriority(PRIO_PROCESS, 0)); }));
  EXPECT_GT(nice.get_future().get(), usual);
  EXPECT_EQ(getpriority(PRIO_PROCESS, 0), usual) << "of this thread";
}

TEST(ServiceQueue, callbacksOfOneThread_runOneAfterTheOther) {
  std::promise<void> may_end;
  std::shared_future<void> end = may_end.get_future().share();
  std::promise<void> has_begun;
  std::atomic<int> done{0};
  std::promise<int> done_before;
  ServiceQueue queue(1, 0, noPriority);
  queue.queue().addCallback(boost::make_shared<Call>([&] {
    has_begun.set_value();
    end.wait();
    ++done;
  }));
  queue.queue().addCallback(boost::make_shared<Call>([&] { done_before.set_value(done.load()); }));
  has_begun.get_future().wait();
  may_end.set_value();
  EXPECT_EQ(done_before.get_future().get(), 1);
}

TEST(ServiceQueue, callbacksOfTwoThreads_runAtTheSameTime) {
  constexpr std::chrono::seconds kLongest(10);
  std::promise<void> has_begun;
  std::promise<bool> met;
  ServiceQueue queue(2, 0, noPriority);
  queue.queue().addCallback(boost::make_shared<Call>([&, other = has_begun.get_future().share()] {
    met.set_value(other.wait_for(kLongest) == std::future_status::ready);
  }));
  queue.queue().addCallback(boost::make_shared<Call>([&] { has_begun.set_value(); }));
  EXPECT_TRUE(met.get_future().get());
}

TEST(ServiceQueue, aThreadThatHurries_hasThePriorityUntilItsCallbackEnds) {
  bool is_permitted = false;
  std::thread([&] { is_permitted = setRealTimePriority(3); }).join();
  if (!is_permitted) {
    GTEST_SKIP() << "the system does not permit real-time priority";
  }
  const auto priority = [] {
    sched_param parameters{};
    sched_getparam(0, &parameters);
    return parameters.sched_priority;
  };
  std::promise<int> hurrying;
  std::promise<int> after;
  ServiceQueue queue(1, 0, [] { return 3; });
  queue.queue().addCallback(boost::make_shared<Call>([&] {
    queue.hurry();
    hurrying.set_value(priority());
  }));
  queue.queue().addCallback(boost::make_shared<Call>([&] { after.set_value(priority()); }));
  EXPECT_EQ(hurrying.get_future().get(), 3);
  EXPECT_EQ(after.get_future().get(), 0);
}

TEST(ServiceQueue, callbackAtItsEnd_isToldAndWaitedFor) {
  std::promise<void> has_begun;
  bool is_done = false;
  {
    ServiceQueue queue(1, 0, noPriority);
    queue.queue().addCallback(boost::make_shared<Call>([&] {
      has_begun.set_value();
      while (!queue.isEnding()) {
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
