// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/CheckStates.h>
#include <collision_monitor/Contacts.h>
#include <collision_monitor/Distances.h>
#include <collision_monitor/State.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <unistd.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "moving_robot.h"

// Measures the cost of a running monitor. Sends joint states and tf of a slowly moving robot of the
// shared data, each 1000 times a second. Listens to state, contacts and distances, and to markers
// if asked to. The robot swings about its zero. If asked to, it swings about the first of seeded
// random configurations whose whole swing is free of contact, or in contact, by the monitor's
// verdict. Prints the processor time of the monitor's process [% of a core], states per second
// [Hz], median and 99th percentile of the time from just before tf is published until the state
// with its stamp is back [us], and the resident memory of the process [MB].
//   node_bench ROBOT PROCESS_ID SECONDS [free|contact] [markers]
namespace collision_monitor::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Listens on its own thread.
class Listener {
 public:
  explicit Listener(bool with_markers) : node_("collision_monitor") {
    node_.setCallbackQueue(&queue_);
    listen<State>("state", [this](const ros::MessageEvent<State const>& event) { take(event); });
    listen<Contacts>("contacts", [](const ros::MessageEvent<Contacts const>&) {});
    listen<Distances>("distances", [](const ros::MessageEvent<Distances const>&) {});
    if (with_markers) {
      using visualization_msgs::MarkerArray;
      listen<MarkerArray>("markers", [](const ros::MessageEvent<MarkerArray const>&) {});
    }
    spinner_.start();
  }

  /// The times from stamp to arrival of the states since the last call. Units: microseconds.
  /// Sorted.
  std::vector<double> takeDelays() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<double> delays;
    delays.swap(delays_);
    std::sort(delays.begin(), delays.end());
    return delays;
  }

 private:
  template <class Message, class Callback>
  void listen(const std::string& topic, const Callback& callback) {
    const boost::function<void(const ros::MessageEvent<Message const>&)> function = callback;
    subscribers_.push_back(node_.subscribe<Message>(topic, 1000, function, ros::VoidConstPtr(),
                                                    ros::TransportHints().tcpNoDelay()));
  }

  void take(const ros::MessageEvent<State const>& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const ros::Time& stamp = event.getMessage()->header.stamp;
    if (stamp > last_) {  // a heartbeat repeats the last one
      last_ = stamp;
      delays_.push_back(1e6 * (event.getReceiptTime() - stamp).toSec());
    }
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
  std::mutex mutex_;  ///< of the next two
  std::vector<double> delays_;
  ros::Time last_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

/// Of all threads of a process, in user and kernel mode. Units: seconds.
double processorTime(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::istringstream fields(text.substr(text.rfind(')') + 1));  // the name may contain anything
  std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
  return (std::stod(words.at(11)) + std::stod(words.at(12))) /
         static_cast<double>(sysconf(_SC_CLK_TCK));
}

double residentMegabytes(const std::string& process) {
  std::ifstream file("/proc/" + process + "/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

void sendFor(double seconds, MovingRobot& robot) {
  const auto cycles = static_cast<int>(1000.0 * seconds);
  Clock::time_point next = Clock::now();
  for (int cycle = 0; cycle < cycles && ros::ok(); ++cycle) {
    next = std::max(next + std::chrono::milliseconds(1), Clock::now());
    std::this_thread::sleep_until(next);
    robot.publish(ros::Time::now());
  }
}

/// Waits until states come, which a new robot can delay, and a little longer.
void warmUp(MovingRobot& robot, Listener& listener) {
  constexpr int kMostSeconds = 60;
  for (int second = 0; second < kMostSeconds && listener.takeDelays().empty(); ++second) {
    sendFor(1.0, robot);
  }
  sendFor(2.0, robot);
  listener.takeDelays();
}

/// Whether the running monitor finds the whole swing in contact, or free of contact.
bool isAll(bool in_contact, const MovingRobot& robot, const std::vector<double>& middle) {
  constexpr int kSteps = 20;  // to either side
  CheckStates check;
  check.request.joint_names = robot.jointNames();
  check.request.only_contacts = 1;
  for (int step = -kSteps; step <= kSteps; ++step) {
    const std::vector<double> state = robot.swingFrom(middle, static_cast<double>(step) / kSteps);
    check.request.positions.insert(check.request.positions.end(), state.begin(), state.end());
  }
  if (!ros::service::call("collision_monitor/check_states", check) || !check.response.success) {
    throw std::runtime_error("check_states failed: " + check.response.message);
  }
  const std::vector<std::uint8_t>& levels = check.response.levels;
  return std::all_of(levels.begin(), levels.end(), [&](std::uint8_t level) {
    return level == (in_contact ? State::CONTACT : State::OK);
  });
}

void chooseSwing(bool in_contact, MovingRobot& robot) {
  constexpr unsigned kMostSeeds = 2000;
  for (unsigned seed = 1; seed <= kMostSeeds; ++seed) {
    const std::vector<double> middle = robot.randomMiddle(seed);
    if (isAll(in_contact, robot, middle)) {
      robot.swingAbout(middle);
      return;
    }
  }
  throw std::runtime_error("no such swing was found");
}

void run(const std::string& robot_name, const std::string& process, double seconds,
         const std::set<std::string>& options) {
  MovingRobot robot(robot_name);
  Listener listener(options.count("markers") > 0);
  warmUp(robot, listener);
  for (const bool in_contact : {false, true}) {
    if (options.count(in_contact ? "contact" : "free") > 0) {
      chooseSwing(in_contact, robot);
      warmUp(robot, listener);
    }
  }
  const double processor_time = processorTime(process);
  const Clock::time_point start = Clock::now();
  sendFor(seconds, robot);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  const double taken = processorTime(process) - processor_time;
  const std::vector<double> delays = listener.takeDelays();
  if (delays.empty()) {
    throw std::runtime_error("no state came");
  }
  const auto count = delays.size();
  std::printf("%.2f %.1f %.0f %.0f %.1f\n", 100.0 * taken / elapsed,
              static_cast<double>(count) / elapsed, delays[count / 2], delays[count * 99 / 100],
              residentMegabytes(process));
}

}  // namespace
}  // namespace collision_monitor::bench

int main(int argc, char** argv) {
  ros::init(argc, argv, "node_bench", ros::init_options::AnonymousName);
  if (argc < 4) {
    std::fprintf(stderr, "usage: node_bench ROBOT PROCESS_ID SECONDS [free|contact] [markers]\n");
    return 2;
  }
  const ros::NodeHandle keeps_ros_running;
  try {
    collision_monitor::bench::run(argv[1], argv[2], std::strtod(argv[3], nullptr),
                                  {argv + 4, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "node_bench: %s\n", error.what());
    return 1;
  }
}
