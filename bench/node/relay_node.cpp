// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/Contacts.h>
#include <collision_monitor/Distances.h>
#include <collision_monitor/State.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include "ros_edge/threads/direct_queue.h"

// Measures roscpp's share of node_bench, without the monitor. Hears joint states and tf, and
// answers each tf message at once, on the thread that delivers it, with state, contacts and
// distances of common size. It does nothing else.
namespace collision_monitor::bench {
namespace {

class Relay {
 public:
  Relay() : node_("collision_monitor") {
    state_.sentence = "panda_link5 is 21 mm from panda_link7, closing at 0.03 m/s";
    state_.closest.link_a = state_.closest.link_b = "panda_link5";
    state_.closest.shape_a = state_.closest.shape_b = "collision_0";
    distances_.pairs.assign(4, state_.closest);
    for (LinkDistance& pair : distances_.pairs) {
      pair.gradient_joints.assign(3, "panda_joint5");
      pair.gradient_values.assign(3, 0.0);
    }
    const ros::TransportHints at_once = ros::TransportHints().tcpNoDelay();
    ros::NodeHandle direct;
    direct.setCallbackQueue(&queue_);
    transforms_ = direct.subscribe("/tf", 100, &Relay::answer, this, at_once);
    joints_ = direct.subscribe("joint_states", 100, &Relay::hear, this, at_once);
  }

 private:
  void hear(const sensor_msgs::JointStateConstPtr& /*message*/) {}

  void answer(const tf2_msgs::TFMessageConstPtr& message) {
    state_.header.stamp = message->transforms.front().header.stamp;
    state_publisher_.publish(state_);
    contacts_publisher_.publish(Contacts());
    distances_publisher_.publish(distances_);
  }

  DirectQueue queue_;
  ros::NodeHandle node_;
  State state_;
  Distances distances_;
  ros::Publisher state_publisher_{node_.advertise<State>("state", 10)};
  ros::Publisher contacts_publisher_{node_.advertise<Contacts>("contacts", 10)};
  ros::Publisher distances_publisher_{node_.advertise<Distances>("distances", 10)};
  ros::Subscriber transforms_;
  ros::Subscriber joints_;
};

}  // namespace
}  // namespace collision_monitor::bench

int main(int argc, char** argv) {
  ros::init(argc, argv, "collision_monitor");
  const collision_monitor::bench::Relay relay;
  ros::spin();
  return 0;
}
