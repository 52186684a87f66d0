// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/watched_robot.h"

#include <time.h>

#include <chrono>
#include <stdexcept>
#include <utility>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/world/add_world.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/parameters/resource_loader.h"
#include "ros_edge/world/convert_objects.h"
#include "ros_edge/world/world_places.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::bench {
namespace {

/// Tells the time since it was last asked.
class StageClock {
 public:
  /// [ms]
  double next() {
    const SteadyClock::time_point now = SteadyClock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(last_, now)).count();
  }

 private:
  SteadyClock::time_point last_ = SteadyClock::now();
};

/// [ms] What all threads of this process have used.
double cpuTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

std::shared_ptr<const MonitorSetup> makeSetup(const std::string& name) {
  const std::optional<test::RobotFile> file = test::findRobot(name);
  if (!file) {
    throw std::runtime_error("there is no robot '" + name + "' in the shared data");
  }
  auto made = std::make_shared<MonitorSetup>();
  SetupOptions& options = made->parameters.setup;
  options.limits.warning_time = 0.0;
  made->setup = buildSetup({test::describe(*file)}, test::fileLoader(file->package_root), options);
  made->robots = std::make_shared<CycleSetup>(withoutPairs(made->setup));
  made->world_frame = made->setup.model.link(made->setup.model.robots.front().root).frame;
  return made;
}

}  // namespace

WatchedRobot::WatchedRobot(const std::string& name)
    : clock_(false, SteadyClock::now()), setup_(makeSetup(name)) {
  place();
  watch_ = std::make_unique<Watch>(setup_, transforms_, joints_);
  cycle();
}

/// Sends the poses of all links, as static transforms.
void WatchedRobot::place() {
  const RobotModel& model = setup_->setup.model;
  const LinkPoses poses = test::posesAt(model, defaultPositions(model));
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Joint& joint : model.joints) {
    geometry_msgs::TransformStamped& transform = transforms.emplace_back();
    transform.header.frame_id = model.link(joint.parent).frame;
    transform.child_frame_id = model.link(joint.child).frame;
    geometry_msgs::Pose pose;
    toMessage(inverse(poses.world_from_link[index(joint.parent)]) *
                  poses.world_from_link[index(joint.child)],
              pose);
    transform.transform.translation.x = pose.position.x;
    transform.transform.translation.y = pose.position.y;
    transform.transform.translation.z = pose.position.z;
    transform.transform.rotation = pose.orientation;
  }
  transforms_.accept(transforms, true);
}

ChangeTimes WatchedRobot::change(const std::vector<SceneChange>& changes) {
  const Inputs inputs{transforms_, joints_, clock_};
  ChangeTimes times;
  const double cpu_before = cpuTime();
  StageClock clock;
  const ResourceLoader load_resource = makeResourceLoader(setup_->parameters.loading);
  SetupReport report;
  const std::vector<ObjectChange> read =
      fromMessages(changes, {load_resource, setup_->parameters.setup.meshes}, report);
  times.read = clock.next();
  const World world = applyChanges(setup_->world, read, placesNow(*setup_, inputs, 0.0), report);
  throwIfErrors(report);
  times.checked = clock.next();
  std::shared_ptr<const MonitorSetup> next = changeWorld(*setup_, world, {});
  times.made = clock.next();
  transforms_.keepOnly(frameNames(*next));
  auto watch = std::make_unique<Watch>(next, transforms_, joints_);
  times.buffered = clock.next();
  watch->planTakeOver(setup_);
  for (int i = 0; i < 2; ++i) {  // as the node does
    const ros::Time now = ros::Time::now();
    watch->prepare(now, lookAtClock(inputs, now));
  }
  times.prepared = clock.next();
  watch->takeOver(*watch_);
  watch_.swap(watch);
  times.swapped = clock.next();
  times.cpu = cpuTime() - cpu_before;
  setup_ = std::move(next);
  return times;
}

double WatchedRobot::cycle() {
  const ros::Time now = ros::Time::now();
  StageClock clock;
  watch_->read(now, lookAtClock({transforms_, joints_, clock_}, now));
  watch_->cycle();
  return clock.next();
}

}  // namespace collision_monitor::bench
