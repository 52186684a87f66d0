// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/node/monitor.h"

#include <ros/console.h>
#include <ros/init.h>

#include <optional>

#include "ros_edge/inputs/clock_feed.h"
#include "ros_edge/node/cycle_runner.h"
#include "ros_edge/outputs/diagnostics.h"
#include "ros_edge/parameters/second_opinion.h"
#include "ros_edge/parameters/startup_report.h"
#include "ros_edge/poses/joint_feed.h"
#include "ros_edge/poses/transform_feed.h"
#include "ros_edge/services/services.h"

namespace collision_monitor {

/// Declared in order of dependence. They are destroyed in reverse: services before what they use.
class Monitor::Parts {
 public:
  Parts(const ros::NodeHandle& private_node, const std::string& node_name, const GoesOn& goes_on)
      : clock_feed_(private_node, clock_),
        runner_(private_node, {store_, joints_, clock_}, makeLoggedSetup(private_node, goes_on),
                log_),
        joint_feed_(private_node, joints_, [this] { wakeForJoints(); }),
        diagnostics_(ros::NodeHandle(), private_node, node_name, runner_.statistics(),
                     [this] { return runner_.currentSetup(); }) {
    tellInputs(*runner_.currentSetup());
    feed_.emplace(private_node, store_);
    joint_feed_.listenTo(jointTopics(*runner_.currentSetup()));
    second_opinion_.askFor(runner_.currentSetup());
    services_.emplace(private_node, Inputs{store_, joints_, clock_}, makeHooks(goes_on), log_);
  }

 private:
  std::shared_ptr<const MonitorSetup> makeLoggedSetup(const ros::NodeHandle& private_node,
                                                      const GoesOn& goes_on) {
    std::shared_ptr<const MonitorSetup> setup = makeMonitorSetup(private_node, goes_on, nullptr);
    logSetup(*setup, log_);
    return setup;
  }

  /// Links may be as old as max_age, and others equally far ahead of now. The rest covers messages
  /// that arrive while a reader works.
  void tellInputs(const MonitorSetup& setup) {
    const double seconds = 2.0 * setup.parameters.max_age + 1.0;
    store_.keepFor(seconds);
    joints_.keepFor(seconds);
    clock_.allow(setup.parameters.clock_timeout);
    store_.keepOnly(frameNames(setup));
    const std::vector<std::string> topics = jointTopics(setup);
    for (std::size_t i = 0; i < topics.size(); ++i) {
      if (!setup.setup.model.robots[i].is_world) {
        joints_.keepOnly(topics[i], jointNames(setup.setup.model, idAt<RobotId>(i)));
      }
    }
  }

  /// Joint states wake those who wait for poses only if they place links.
  void wakeForJoints() {
    if (runner_.currentSetup()->parameters.pose_source == PoseSource::joint_states) {
      store_.wake();
    }
  }

  ServiceHooks makeHooks(const GoesOn& goes_on) {
    ServiceHooks hooks;
    hooks.goes_on = goes_on;
    hooks.current_setup = [this] { return runner_.currentSetup(); };
    hooks.replace_setup = [this](const std::shared_ptr<const MonitorSetup>& setup) {
      std::unique_ptr<Watch> watch = runner_.makeWatch(setup);  // before anything changes
      tellInputs(*setup);
      joint_feed_.listenTo(jointTopics(*setup));
      runner_.replaceWatch(std::move(watch));
      second_opinion_.askFor(setup);
    };
    hooks.change_setup = [this](const std::shared_ptr<const MonitorSetup>& setup) {
      store_.keepOnly(frameNames(*setup));  // first, so that it has their transforms
      runner_.replaceWatch(runner_.makeWatch(setup));
    };
    hooks.view_pair = [this](const std::string& link_a, const std::string& link_b) {
      return runner_.viewPair(link_a, link_b);
    };
    hooks.network_priority = [this] { return runner_.networkPriority(); };
    hooks.set_enabled = [this](bool is_enabled) { runner_.setEnabled(is_enabled); };
    return hooks;
  }

  LogThread log_;
  TransformStore store_;
  JointStore joints_;
  ClockWatch clock_{ros::Time::isSimTime(), SteadyClock::now()};
  ClockFeed clock_feed_;
  SecondOpinion second_opinion_{log_};
  CycleRunner runner_;
  std::optional<TransformFeed> feed_;  ///< made once the wanted frames are known
  JointFeed joint_feed_;
  Diagnostics diagnostics_;
  std::optional<Services> services_;  ///< made last: from then on the set-up may change
};

Monitor::Monitor(const ros::NodeHandle& private_node, const std::string& node_name,
                 const GoesOn& goes_on)
    : parts_(std::make_unique<Parts>(private_node, node_name,
                                     [goes_on] { return ros::ok() && (!goes_on || goes_on()); })) {}

Monitor::~Monitor() = default;

}  // namespace collision_monitor
