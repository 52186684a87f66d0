// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>

#include <atomic>
#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <thread>

#include "ros_edge/node/monitor.h"
#include "ros_edge/parameters/startup_report.h"

namespace collision_monitor {

/// The monitor inside a nodelet manager. It builds the set-up on its own thread, because the
/// manager must not wait for robot descriptions. If the set-up fails, it logs that and the manager
/// lives on.
class MonitorNodelet : public nodelet::Nodelet {
 public:
  ~MonitorNodelet() override {
    is_ending_ = true;
    if (builder_.joinable()) {
      builder_.join();
    }
  }

 private:
  void onInit() override {
    const ros::NodeHandle private_node = getMTPrivateNodeHandle();
    builder_ = std::thread([this, private_node] {
      try {
        monitor_ =
            std::make_unique<Monitor>(private_node, getName(), [this] { return !is_ending_; });
      } catch (const std::exception& error) {
        logFailure(error);
      } catch (const Interrupted&) {
        // Unloaded before it began.
      }
    });
  }

  std::unique_ptr<Monitor> monitor_;
  std::atomic<bool> is_ending_{false};
  std::thread builder_;
};

}  // namespace collision_monitor

PLUGINLIB_EXPORT_CLASS(collision_monitor::MonitorNodelet, nodelet::Nodelet)
