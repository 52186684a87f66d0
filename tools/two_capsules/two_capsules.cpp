// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PointStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <optional>
#include <string>
#include <utility>

#include "draw.h"
#include "keyboard.h"
#include "ros_edge/node/node_arguments.h"

namespace collision_monitor::two_capsules {
namespace {

const char* const kUsage =
    "An exercise in rviz: three clicks make a capsule, two capsules show their distance.\n"
    "\n"
    "Usage: roslaunch collision_monitor two_capsules.launch\n"
    "       rosrun collision_monitor two_capsules [NAME:=VALUE ...]\n"
    "\n"
    "  _frame:=map     frame of the board; default: world\n"
    "  __name:=NAME    name of the node; __ns, __log, __ip as of every ROS node\n"
    "  --help          this text\n"
    "\n"
    "Listens to clicked_point, of rviz's Publish Point\n"
    "Publishes  below its name: markers\n"
    "Serves     below its name: reset\n"
    "Keys       R clears the board, Q ends\n"
    "\n"
    "Exit code: 0, it was told to end. 1, a parameter is at fault. 2, the command line is.\n";

/// Connects rviz's Publish Point tool, the exercise and its markers. Both use one frame, the
/// parameter `frame`.
class Scene {
 public:
  explicit Scene(std::string frame)
      : frame_(std::move(frame)),
        markers_(private_node_.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
        clicks_(ros::NodeHandle().subscribe("clicked_point", 10, &Scene::hear, this)),
        reset_service_(private_node_.advertiseService("reset", &Scene::serveReset, this)) {
    show();
  }

  void reset() {
    exercise_ = {};
    show();
  }

 private:
  void hear(const geometry_msgs::PointStamped& click) {
    if (click.header.frame_id == frame_) {
      takeClick({click.point.x, click.point.y, click.point.z}, exercise_);
    } else {
      exercise_.refusal = "refused: the click is in frame '" + click.header.frame_id +
                          "', the board in '" + frame_ + "'";
    }
    show();
  }

  bool serveReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    reset();
    response.success = 1;
    response.message = promptOf(exercise_);
    return true;
  }

  void show() {
    markers_.publish(draw(exercise_, frame_));
    if (const auto found = distanceOf(exercise_); found && exercise_.refusal.empty()) {
      ROS_INFO_STREAM("distance: " << distanceText(found->distance));
    }
    ROS_INFO_STREAM(promptOf(exercise_));
  }

  ros::NodeHandle private_node_{"~"};
  Exercise exercise_;
  std::string frame_;
  ros::Publisher markers_;
  ros::Subscriber clicks_;
  ros::ServiceServer reset_service_;
};

/// The parameter `frame`; nothing after an error if it is no valid frame name.
std::optional<std::string> readFrame() {
  const ros::NodeHandle node("~");
  std::string frame = "world";
  if (node.hasParam("frame") && (!node.getParam("frame", frame) || frame.empty())) {
    ROS_FATAL_STREAM("parameter " << node.resolveName("frame")
                                  << ": no text, or an empty one; accepted: the name of a frame");
    return std::nullopt;
  }
  return frame;
}

void run(const std::string& frame) {
  const Keyboard keyboard;
  ROS_INFO_STREAM((keyboard.isThere() ? "keys: R clears the board, Q ends"
                                      : "no terminal to read keys from; clear the board by "
                                        "rosservice call " +
                                            ros::this_node::getName() + "/reset"));
  Scene scene(frame);
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    const char key = keyboard.read();
    if (key == 'r' || key == 'R') {
      scene.reset();
    } else if (key == 'q' || key == 'Q') {
      ros::shutdown();
    }
  }
}

}  // namespace
}  // namespace collision_monitor::two_capsules

int main(int argc, char** argv) {
  using namespace collision_monitor;
  if (const auto code = answerArguments(argc, argv, two_capsules::kUsage)) {
    return *code;
  }
  if (const auto code = initNode(argc, argv, "two_capsules")) {
    return *code;
  }
  // Outside the reading function: ROS shuts its log down when the last handle ends.
  const ros::NodeHandle node;
  const auto frame = two_capsules::readFrame();
  if (!frame) {
    return kFault;
  }
  two_capsules::run(*frame);
  return kDone;
}
