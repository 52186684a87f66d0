// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_scene.h"

#include <algorithm>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {

std::shared_ptr<const MonitorSetup> slidingSetup(const SetupOptions& options) {
  const std::string cube = "<box size='0.2 0.2 0.2'/>";
  const std::string along_x =
      "<axis xyz='1 0 0'/><limit lower='-9' upper='9' velocity='1' effort='1'/>";
  const std::string xml =
      linkXml("base", cube) + linkXml("slider", cube, "<origin xyz='0 0 -5'/>") +
      linkXml("tool", cube) + linkXml("finger", cube) + "<link name='antenna'/>" +
      jointXml("slide", "prismatic", "base", "slider", along_x) +
      jointXml("reach", "prismatic", "slider", "tool", "<origin xyz='0.5 0 0'/>" + along_x) +
      jointXml("follow", "prismatic", "slider", "finger",
               "<origin xyz='0 1 0'/>" + along_x +
                   "<mimic joint='slide' multiplier='2' offset='0.1'/>") +
      jointXml("mast", "fixed", "base", "antenna");
  auto made = std::make_shared<MonitorSetup>();
  made->setup = buildSetup({describeText(robotXml(xml))}, textLoader({}), options);
  made->world_frame = "base";
  return made;
}

LinkPoses slidingPoses(const RobotModel& model, double slide, double reach) {
  JointPositions positions(model.variable_count, 0.0);
  positions[model.joint(*model.findJoint("slide")).first_variable] = slide;
  positions[model.joint(*model.findJoint("reach")).first_variable] = reach;
  LinkPoses poses = makeLinkPoses(model);
  placeLinks(model, positions, {Pose()}, poses.world_from_link);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  std::fill(poses.age.begin(), poses.age.end(), 0.0);
  poses.stamp_ns = 12'500'000'000;
  return poses;
}

NewestState newestAt(const RobotModel& model, const LinkPoses& poses) {
  NewestState newest = makeNewestState(model);
  newest.poses = poses;
  newest.reasons[0] = "no transform from 'world' to 'base' yet";
  return newest;
}

void floatSlider(const RobotModel& model, LinkPoses& poses) {
  const std::size_t slider = index(linkNamed(model, "slider"));
  const Pose slider_from_world = inverse(poses.world_from_link[slider]);
  for (const char* name : {"slider", "tool", "finger"}) {
    const std::size_t link = index(linkNamed(model, name));
    poses.world_from_link[link] = slider_from_world * poses.world_from_link[link];
    poses.part[link] = static_cast<PartId>(slider);
    poses.part_status[link] = LinkStatus::stale;
  }
}

std::unique_ptr<Watch> judged(const std::shared_ptr<const MonitorSetup>& setup,
                              const TransformStore& store, const LinkPoses& poses) {
  static const JointStore no_joint_states;
  auto watch = std::make_unique<Watch>(setup, store, no_joint_states);
  watch->poses = poses;
  runCycle(watch->setup(), watch->poses, watch->buffers);
  return watch;
}

std::unique_ptr<Watch> estimatedDepth(const TransformStore& store) {
  SetupOptions options;
  options.limits.contact_distance = -0.1;
  const auto setup = slidingSetup(options);
  auto watch = judged(setup, store, slidingPoses(setup->setup.model, 0.0, -0.34));
  CycleBuffers& buffers = watch->buffers;
  buffers.distances.pairs.at(buffers.events.closest_of_all).quality = Quality::estimate;
  judgePairs(setup->setup, buffers.body_poses, watch->poses.velocities, buffers.distances,
             buffers.memory, buffers.events);
  return watch;
}

LinkId linkNamed(const RobotModel& model, const std::string& name) {
  return model.findLink(name).value();
}

}  // namespace collision_monitor::test
