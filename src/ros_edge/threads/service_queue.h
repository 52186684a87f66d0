// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace collision_monitor {

/// A callback queue with threads of its own, for services. Calls do not delay callbacks of other
/// queues.
///
/// While roscpp sends an answer it holds the lock of all sockets, for which its network thread
/// waits, and so does the cycle. So answers are sent with the priority of the network thread.
class ServiceQueue {
 public:
  /// @param threads how many calls may run at the same time
  /// @param nicer what is added to the nice value of the threads, up to the maximum
  /// @param priority of the network thread, as for setRealTimePriority. Any thread may ask.
  ServiceQueue(int threads, int nicer, std::function<int()> priority);
  /// Waits for the current calls.
  ~ServiceQueue();
  ServiceQueue(const ServiceQueue&) = delete;
  ServiceQueue& operator=(const ServiceQueue&) = delete;

  /// @pre the queue and `owner` outlive the service
  template <class Owner, class Request, class Response>
  ros::ServiceServer serve(ros::NodeHandle node, const std::string& name,
                           bool (Owner::*answer)(Request&, Response&), Owner* owner) {
    node.setCallbackQueue(&queue_);
    return node.advertiseService<Request, Response>(
        name, [this, owner, answer](Request& request, Response& response) {
          const bool is_answered = (owner->*answer)(request, response);
          hurry();
          return is_answered;
        });
  }

  /// Must not be used after this object's end.
  ros::CallbackQueue& queue() noexcept { return queue_; }
  /// Gives the calling thread the priority of the network thread until its callback ends.
  /// @pre the thread is one of the queue's
  void hurry() noexcept;
  /// Asks calls to give up, if they check isEnding. No new call starts afterwards.
  void end() noexcept { is_ending_ = true; }
  bool isEnding() const noexcept { return is_ending_; }

 private:
  void run(int nicer);

  ros::CallbackQueue queue_;
  std::function<int()> priority_;
  std::atomic<bool> is_ending_{false};
  std::vector<std::thread> threads_;  ///< last: they use the members above
};

}  // namespace collision_monitor
