// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/watch.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "pipeline/answers/carry_measurements.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/look_ahead/find_motions.h"
#include "pipeline/objects/carry_objects.h"
#include "ros_edge/outputs/pair_counts.h"
#include "ros_edge/poses/floating_parts.h"
#include "ros_edge/robots/absence.h"
#include "ros_edge/robots/missing.h"

namespace collision_monitor {

namespace {

std::vector<std::vector<bool>> findChecked(const CycleSetup& setup, const RobotSpeeds& speeds) {
  const std::size_t robots = robotCount(setup.model);
  std::vector<std::vector<bool>> is_checked(robots + 1, std::vector<bool>(robots + 1));
  for (const CheckedLinkPair& pair : setup.checked) {
    const std::size_t a = speeds.robot_of_link[index(pair.a)];
    const std::size_t b = speeds.robot_of_link[index(pair.b)];
    is_checked[a][b] = is_checked[b][a] = true;
  }
  return is_checked;
}

}  // namespace

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
      is_checked_between(findChecked(setup(), buffers.robots)),
      joined_to(poses.part.size()),
      was_there(robotCount(setup().model), 0) {
  forgetJoined();
  std::fill(buffers.refine.told_below.begin(), buffers.refine.told_below.end(),
            NearestSeen::Record().distance);
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

bool Watch::noteJoined() noexcept {
  bool have_joined = false;
  for (const Robot& robot : setup().model.robots) {
    forOwnLinks(setup().model, robot, [&](std::size_t link) {
      const auto own = static_cast<PartId>(link);
      const PartId part = poses.status[link] == LinkStatus::known ? poses.part[link] : own;
      have_joined = have_joined || (part != own && part != joined_to[link]);
      joined_to[link] = part;
    });
  }
  return have_joined;
}

void Watch::forgetJoined() noexcept { std::iota(joined_to.begin(), joined_to.end(), PartId{0}); }

/// The first cycle learns what the former watch has not: pairs of links that joined others since.
void Watch::unlearnJoined(const Watch& former) noexcept {
  for (const Robot& robot : fixed->robots->model.robots) {
    forOwnLinks(setup().model, robot, [&](std::size_t link) {
      const auto own = static_cast<PartId>(link);
      joined_to[link] = former.joined_to[link] == own ? own : joined_to[link];
    });
  }
}

void Watch::noteAbsent() noexcept {
  for (const ListedRobot& robot : fixed->listed) {
    if (robot.id) {
      const bool is_absent = isAbsent(setup().model, *robot.id, poses);
      buffers.robots.is_excused[index(*robot.id)] = is_absent && robot.may_be_absent ? 1 : 0;
      was_there[index(*robot.id)] |= is_absent ? 0 : 1;
    }
  }
}

void Watch::cycle() noexcept {
  if (noteJoined()) {
    learnPairs(setup(), poses, buffers);
  }
  noteAbsent();
  if (is_new_) {
    holdNewPairs();
    is_new_ = false;
  }
  runCycle(setup(), poses, buffers);
  nearest.add(setup(), poses, joints, buffers);
}

void Watch::forget() {
  forgetPoses(buffers);
  forgetJoined();
  resetTracker(tracker);
}

void Watch::pauseReporting() { believed = buffers.memory.reported; }

void Watch::resumeReporting() {
  buffers.memory.reported = believed;
  buffers.memory.judges_all = true;
  buffers.memory.speed.scale = 0.0;  // the value sent while switched off
  std::fill(buffers.robots.scales.begin(), buffers.robots.scales.end(), 0.0);
  forgetPoses(buffers);
  forgetJoined();
}

void Watch::planTakeOver(std::shared_ptr<const MonitorSetup> former) {
  carried = planCarryOver(former->setup, setup());
  if (former->robots == fixed->robots) {  // not reloaded
    new_element_pair_of = planMeasurements(former->setup, setup(), carried);
    buffers.refine.skips_robots = !new_element_pair_of.empty();
  }
  const auto added = std::count(carried.pair_of.begin(), carried.pair_of.end(), kNone);
  nearest.touchRoomFor(carried.pair_of.size() - static_cast<std::size_t>(added));
  planned_from = std::move(former);
}

void Watch::prepare(const ros::Time& now, const ClockState& clock_now) {
  read(now, clock_now);
  noteJoined();
  noteAbsent();
  prepareFirstCycle(setup(), poses, buffers);
}

std::vector<LinkPairIndex> Watch::takeOver(Watch& former) {
  if (planned_from != former.fixed) {
    carried = planCarryOver(former.setup(), setup());
    new_element_pair_of.clear();
    if (std::exchange(buffers.refine.skips_robots, false)) {
      learnPairs(setup(), poses, buffers);
    }
  }
  carryMotion(carried, setup(), {former.poses, former.buffers.memory.last, former.tracker}, poses,
              buffers.memory, tracker);
  std::vector<LinkPairIndex> dropped = carryOver(carried, former.buffers.memory, buffers.memory);
  if (!new_element_pair_of.empty()) {
    carryMeasurements(new_element_pair_of, former.buffers, buffers);
    unlearnJoined(former);
  }
  takeOverScales(former);
  for (std::size_t i = 0; i < was_there.size(); ++i) {
    was_there[i] = carried.robot_of[i] == kNone ? 0 : former.was_there[carried.robot_of[i]];
  }
  if (former.fixed->robots == fixed->robots) {  // not reloaded
    nearest.inherit(former.nearest, carried.pair_to, buffers.refine);
  }
  planned_from.reset();
  is_new_ = true;
  return dropped;
}

/// Pairs that were not checked may have been near when one of their robots fell silent, as after a
/// mute. Nobody knows, so they are held as pairs that were.
void Watch::holdNewPairs() noexcept {
  const auto is_silent = [&](std::size_t robot) {
    return robot < was_there.size() && was_there[robot] != 0 &&
           buffers.robots.is_excused[robot] != 0;
  };
  bool is_any_silent = false;
  for (std::size_t i = 0; i < was_there.size(); ++i) {
    is_any_silent = is_any_silent || is_silent(i);
  }
  buffers.memory.judges_all |= is_any_silent;
  const auto fell_silent = [&](LinkId link) {
    return is_silent(buffers.robots.robot_of_link[index(link)]);
  };
  for (LinkPairIndex i = 0; is_any_silent && i < carried.pair_of.size(); ++i) {
    const CheckedLinkPair& pair = setup().checked[i];
    const bool were_there =
        carried.link_of[index(pair.a)] != kNone && carried.link_of[index(pair.b)] != kNone;
    if (carried.pair_of[i] == kNone && were_there && (fell_silent(pair.a) || fell_silent(pair.b))) {
      buffers.memory.reported[i] = Verdict::unknown;
    }
  }
}

/// Whatever was published as 0 grows from 0 on.
void Watch::takeOverScales(const Watch& former) {
  std::vector<double>& scales = buffers.robots.scales;
  for (std::size_t i = 0; i + 1 < scales.size(); ++i) {  // without what no robot moves
    if (carried.robot_of[i] != kNone) {
      scales[i] = former.buffers.robots.scales[carried.robot_of[i]];
    }
  }
  if (isAnyMissing(*former.fixed)) {
    buffers.memory.speed.scale = 0.0;
  }
  const bool stood = isAnyAwaited(*former.fixed);
  for (const ListedRobot& robot : fixed->listed) {
    const bool was_missing = std::any_of(
        former.fixed->listed.begin(), former.fixed->listed.end(),
        [&](const ListedRobot& before) { return before.name == robot.name && !before.id; });
    if (robot.id && (stood || was_missing)) {
      scales[index(*robot.id)] = 0.0;
    }
  }
}

const Unknowns& Watch::unknown() const {
  last_unknown.find(setup(), poses, buffers);
  return last_unknown;
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

}  // namespace collision_monitor
