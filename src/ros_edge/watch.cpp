// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/watch.h"

#include <algorithm>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/look_ahead/find_motions.h"
#include "pipeline/objects/carry_objects.h"
#include "ros_edge/outputs/pair_counts.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/robots/absence.h"

namespace collision_monitor {

Watch::Watch(std::shared_ptr<const MonitorSetup> fixed_parts, const TransformStore& store,
             const JointStore& joint_store)
    : fixed(std::move(fixed_parts)),
      joints(fixed->setup.model, joint_store, jointTopics(*fixed)),
      reader(makePoseReader(*fixed, store, joints)),
      poses(makeLinkPoses(fixed->setup.model)),
      tracker(makeVelocityTracker(fixed->setup.model)),
      joint_velocities(fixed->setup.model.variable_count),
      buffers(makeBuffers(fixed->setup, fixed->parameters.broad_phase)),
      budget(makeBudgetTally(fixed->setup)),
      believed(buffers.memory.reported),
      pairs_ignored(static_cast<std::uint32_t>(
          countOf(PairReason::ignored_by_user, countPairs(fixed->setup.link_pairs)))),
      pairs_muted(static_cast<std::uint32_t>(
          countOf(PairReason::muted, countPairs(fixed->setup.link_pairs)))),
      last_mute(lastMuteOf(*fixed)),
      nearest(fixed->setup),
      is_robot_checked(buffers.robots.scales.size(), 0) {
  for (const CheckedLinkPair& pair : setup().checked) {
    is_robot_checked[buffers.robots.robot_of_link[index(pair.a)]] = 1;
    is_robot_checked[buffers.robots.robot_of_link[index(pair.b)]] = 1;
  }
}

PoseReader makePoseReader(const MonitorSetup& setup, const TransformStore& store,
                          JointReader& joints) {
  const bool reads_joints = setup.parameters.pose_source == PoseSource::joint_states;
  return {setup.setup.model,
          store,
          {setup.world_frame, setup.parameters.max_age},
          reads_joints ? &joints : nullptr};
}

bool growStale(LinkPoses& poses) noexcept {
  bool has_changed = false;
  for (LinkStatus& status : poses.status) {
    has_changed = has_changed || status == LinkStatus::known;
    status = status == LinkStatus::known ? LinkStatus::stale : status;
  }
  std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 0);
  return has_changed;
}

bool Watch::read(const ros::Time& now, const ClockState& clock_now) {
  clock = clock_now;
  if (now.isZero()) {
    clock.fault = ClockFault::not_started;
    std::fill(poses.status.begin(), poses.status.end(), LinkStatus::missing);
    std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 0);
    return false;
  }
  if (clock.fault != ClockFault::none) {
    return growStale(poses);
  }
  const Parameters& parameters = fixed->parameters;
  const bool is_new = reader.read(now, poses);
  trackVelocities(setup().model, {parameters.velocity_filter, parameters.max_age}, tracker, poses);
  joints.refresh();
  joints.readVelocities(now, parameters.max_age, joint_velocities);
  applyJointVelocities(setup().model, joint_velocities, poses);
  carryVelocities(tracker.objects, poses);
  return is_new;
}

void Watch::cycle() noexcept {
  const auto known = std::count(poses.status.begin(), poses.status.end(), LinkStatus::known);
  if (known > links_known) {
    learnPairs(setup(), poses, buffers);
  }
  links_known = known;
  for (const ListedRobot& robot : fixed->listed) {
    if (robot.id && robot.may_be_absent) {
      buffers.robots.is_excused[index(*robot.id)] =
          isAbsent(setup().model, *robot.id, poses) ? 1 : 0;
    }
  }
  runCycle(setup(), poses, buffers);
  nearest.add(setup(), poses, joints, buffers);
}

void Watch::forget() {
  forgetPoses(buffers);
  links_known = 0;
  resetTracker(tracker);
}

void Watch::pauseReporting() { believed = buffers.memory.reported; }

void Watch::resumeReporting() {
  buffers.memory.reported = believed;
  buffers.memory.judges_all = true;
  buffers.memory.speed.scale = 0.0;  // the value sent while switched off
  std::fill(buffers.robots.scales.begin(), buffers.robots.scales.end(), 0.0);
  forgetPoses(buffers);
  links_known = 0;
}

void Watch::prepare(const ros::Time& now, const ClockState& clock_now,
                    std::shared_ptr<const MonitorSetup> former) {
  read(now, clock_now);
  links_known = std::count(poses.status.begin(), poses.status.end(), LinkStatus::known);
  learnPairs(setup(), poses, buffers);
  keepPoses(poses, buffers.body_poses, buffers.memory.last);
  carried = planCarryOver(former->setup, setup());
  planned_from = std::move(former);
}

std::vector<LinkPairIndex> Watch::takeOver(const Watch& former) {
  if (planned_from != former.fixed) {
    carried = planCarryOver(former.setup(), setup());
  }
  carryMotion(carried, setup(), {former.poses, former.buffers.memory.last, former.tracker}, poses,
              buffers.memory, tracker);
  std::vector<LinkPairIndex> dropped = carryOver(carried, former.buffers.memory, buffers.memory);
  for (std::size_t i = 0; i + 1 < buffers.robots.scales.size(); ++i) {
    if (carried.robot_of[i] != kNone) {
      buffers.robots.scales[i] = former.buffers.robots.scales[carried.robot_of[i]];
    }
  }
  if (former.fixed->robots == fixed->robots) {  // not reloaded
    nearest.inherit(former.nearest, carried.pair_of);
  }
  carried = CarryPlan();
  planned_from.reset();
  return dropped;
}

double Watch::mutedFor(RuleEnd now) const {
  return last_mute ? std::max(0.0, std::chrono::duration<double>(*last_mute - now).count()) : 0.0;
}

void countStep(const SweepWork& work, StepCount& count) noexcept {
  if (work.elapsed > 0.0) {
    count.over_cap += work.step.at_poses.is_exceeded ? 1 : 0;
    count.too_long += work.step.on_way.is_exceeded ? 1 : 0;
  }
}

void findUnknownLinks(const Watch& watch, std::vector<LinkId>& links) {
  links.clear();
  if (watch.buffers.events.unknown == 0) {
    return;
  }
  const CycleSetup& setup = watch.setup();
  const MainPart main(watch.poses, setup.checked);
  std::vector<bool> is_unknown(setup.model.links.size());
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    if (watch.buffers.events.verdicts[i] == Verdict::unknown) {
      is_unknown[index(setup.checked[i].a)] = true;
      is_unknown[index(setup.checked[i].b)] = true;
    }
  }
  for (std::size_t i = 0; i < is_unknown.size(); ++i) {
    if (is_unknown[i] && !main.has(idAt<LinkId>(i))) {
      links.push_back(idAt<LinkId>(i));
    }
  }
}

}  // namespace collision_monitor
