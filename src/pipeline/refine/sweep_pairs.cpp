// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/sweep_pairs.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "collision_monitor/geometry/ids.h"
#include "motion/approach.h"
#include "motion/moving_sphere.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/refine/recall_elements.h"
#include "pipeline/refine/sweep_elements.h"

namespace collision_monitor {
namespace {

/// Work for two moving bodies: six distances are usual, and a grazing pair must not hold up a
/// cycle.
constexpr std::uint32_t kBodyWork = 500;

/// The arguments of sweepPairs.
struct Sweeping {
  const CycleSetup& setup;
  const RefineStore& memory;
  const RefineWork& refined;
  SweepWork& work;
  PairDistances& distances;

  /// Whether an entry represents two elements and all of their bodies.
  bool isOfElements(PairId pair) const noexcept {
    return refined.is_measured[setup.element_pair_of[index(pair)]] != 0;
  }
  const CheckedLinkPair& linksOf(PairId pair) const noexcept {
    return setup.checked[setup.link_pair_of[index(pair)]];
  }
  const ScrewMotion& motionOf(LinkId link) const noexcept { return work.link_motions[index(link)]; }
  ScrewMotion motionOf(const Body& body) const noexcept {
    return carriedBy(motionOf(body.link), body.link_from_body);
  }
};

/// Whether two bodies (or elements, if refined) may have met since the last cycle, by their
/// distance now and their travel.
bool mayHaveMet(const Sweeping& all, const PairDistance& distance) noexcept {
  const SweepWork& work = all.work;
  const CheckedLinkPair& links = all.linksOf(distance.pair);
  if (work.has_motion[index(links.a)] == 0 || work.has_motion[index(links.b)] == 0 ||
      isTouching(distance, limitsOf(all.setup, links).contact_distance)) {
    return false;
  }
  if (all.isOfElements(distance.pair)) {
    const ElementPairIndex index_of = all.setup.element_pair_of[index(distance.pair)];
    const ElementPair& pair = all.setup.element_pairs[index_of];
    const double outside = all.refined.tasks[all.refined.task_of[index_of]].outside;
    return std::min(distance.measured.distance - contactOfElements(all.setup, index_of), outside) <=
           work.element_travel[index(pair.a)] + work.element_travel[index(pair.b)];
  }
  const BodyPair& bodies = all.setup.table[distance.pair];
  return distance.measured.distance - contactOfBodies(all.setup, distance.pair) <=
         work.body_travel[index(bodies.a)] + work.body_travel[index(bodies.b)];
}

/// Tests moving spheres first, then the shapes.
SweptContact sweepBodies(const Sweeping& all, PairId pair) noexcept {
  const Body& a = all.setup.bodies[index(all.setup.table[pair].a)];
  const Body& b = all.setup.bodies[index(all.setup.table[pair].b)];
  const ScrewMotion motion_a = all.motionOf(a);
  const ScrewMotion motion_b = all.motionOf(b);
  SweepLimits limits;
  limits.contact_distance = contactOfBodies(all.setup, pair);
  limits.budget = kBodyWork;
  const double margin = limits.contact_distance + limits.tolerance;
  const MovingSphere sphere_a =
      movingSphereOf(motion_a, Eigen::Vector3d::Zero(), a.bounding_radius);
  const MovingSphere sphere_b =
      movingSphereOf(motion_b, Eigen::Vector3d::Zero(), b.bounding_radius);
  if (!mayMeetBySpeed(sphere_a, sphere_b, margin) ||
      !mayMeetByClosing(sphere_a, sphere_b, margin)) {
    SweptContact clear;
    clear.state = SweepState::clear;
    return clear;
  }
  return firstContact({a.shape, motion_a}, {b.shape, motion_b}, limits);
}

/// A contact at the start is one of the last cycle.
bool isNew(const SweptContact& found) noexcept {
  return found.state == SweepState::undecided ||
         (found.state == SweepState::contact && found.time > 0.0);
}

void tell(const Sweeping& all, PairId pair, const SweptContact& found, Quality quality,
          bool is_refined) noexcept {
  const CheckedLinkPair& links = all.linksOf(pair);
  all.distances.passed.push_back({found.time,
                                  {pair, quality, is_refined, found.measured},
                                  poseAt(all.motionOf(links.a), found.time),
                                  poseAt(all.motionOf(links.b), found.time)});
}

void addTask(const Sweeping& all, const SweepTask& task) noexcept {
  SweepWork& work = all.work;
  std::uint32_t& place = work.task_of[task.pair];
  if (place == kNone) {
    place = static_cast<std::uint32_t>(work.tasks.size());
    work.tasks.push_back(task);
  } else if (task.from < work.tasks[place].from) {
    work.tasks[place] = task;
  }
}

/// Bodies that did not meet need nothing more; for those that met, their elements are followed.
void sweepDistance(const Sweeping& all, const PairDistance& distance) noexcept {
  const CycleSetup& setup = all.setup;
  const ElementPairIndex pair = setup.element_pair_of[index(distance.pair)];
  ++all.work.swept;
  if (all.isOfElements(distance.pair)) {
    // The entry represents all bodies of these elements.
    addTask(all, {pair, distance.pair, 0.0, distance.measured, 0});
    return;
  }
  const SweptContact found = sweepBodies(all, distance.pair);
  if (found.state == SweepState::clear) {
    return;
  }
  const ElementPair& elements = setup.element_pairs[pair];
  if (!setup.elements[index(elements.a)].is_body || !setup.elements[index(elements.b)].is_body) {
    addTask(all, {pair, distance.pair, found.time, found.measured, 0});
  } else if (isNew(found)) {
    const bool is_exact = distance.quality == Quality::exact && found.state == SweepState::contact;
    tell(all, distance.pair, found, is_exact ? Quality::exact : Quality::lower_bound, false);
  }
}

MovingElement movingElement(const Sweeping& all, ElementId id, const ScrewMotion& motion) noexcept {
  return {all.setup.elements[index(id)], all.refined.balls[index(id)], motion};
}

/// [m] A lower bound of distance minus contact distance of two elements at a time, by their last
/// measurements.
double gapAt(double time, const Sweeping& all, ElementPairIndex pair, const MovingElement& a,
             const MovingElement& b) noexcept {
  const Pose world_from_a = poseAt(a.motion, time);
  const Pose world_from_b = poseAt(b.motion, time);
  double gap = -std::numeric_limits<double>::infinity();
  for (const LastMeasurement* measured : {&all.memory.lastOf(pair), &all.memory.beforeOf(pair)}) {
    const ElementDistance known = recallElements(*measured, {a.element, world_from_a},
                                                 {b.element, world_from_b}, {a.ball, b.ball});
    if (known.quality == Quality::exact || known.quality == Quality::lower_bound) {
      gap = std::max(gap, std::min(known.measured.distance - contactOfElements(all.setup, pair),
                                   known.outside));
    }
  }
  return gap;
}

/// Narrows the times at which elements may meet, by their gaps at the start and at the end: meeting
/// uses up the first gap, and parting again uses up the second.
void narrow(const Sweeping& all, ElementPairIndex pair, const MovingElement& a,
            const MovingElement& b, SweepLimits& limits) noexcept {
  const bool is_a_smaller = a.ball.radius < b.ball.radius;
  const MovingElement& smaller = is_a_smaller ? a : b;
  const Approach approach =
      approachAt((is_a_smaller ? b : a).motion, smaller.motion, smaller.ball, 0.0);
  const Consumption motion = ofBall(approach, approach.center, approach.radius);
  const double before = gapAt(0.0, all, pair, a, b) - limits.tolerance;
  const double until = motion.within(1.0) - (gapAt(1.0, all, pair, a, b) - limits.tolerance);
  if (before > 0.0) {
    limits.from = std::max(limits.from, timeToConsume(before, motion));
  }
  if (until < motion.within(1.0)) {
    limits.until = until > 0.0 ? std::min(1.0, timeToConsume(until, motion)) : 0.0;
  }
}

void sweepTask(const Sweeping& all, SweepTask& task) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  const Element& a = all.setup.elements[index(pair.a)];
  const Element& b = all.setup.elements[index(pair.b)];
  const ScrewMotion motion_a = carriedBy(all.motionOf(a.link), a.link_from_element);
  const ScrewMotion motion_b = carriedBy(all.motionOf(b.link), b.link_from_element);
  SweepLimits limits;
  limits.contact_distance = limitsOf(all.setup, pair.link_pair).contact_distance;
  limits.from = task.from;
  limits.budget = all.work.budget - std::min(all.work.budget, all.work.work_done);
  const MovingElement moving_a = movingElement(all, pair.a, motion_a);
  const MovingElement moving_b = movingElement(all, pair.b, motion_b);
  narrow(all, task.pair, moving_a, moving_b, limits);
  if (!(limits.from < limits.until)) {
    return;
  }
  SweptContact found = sweepElements(moving_a, moving_b, limits, *all.refined.scratch);
  task.work = found.work;
  all.work.work_done += found.work;
  if (!isNew(found)) {
    return;
  }
  const bool is_contact = found.state == SweepState::contact;
  const bool is_exact = a.is_exact && b.is_exact && a.padding + b.padding == 0.0;
  if (!is_contact) {
    ++all.work.left;
    found.measured = task.measured;  // of the bodies: no distance of the elements is settled
  }
  const Quality quality = is_contact && is_exact ? Quality::exact : Quality::lower_bound;
  tell(all, task.bodies, found, quality, is_contact);
}

}  // namespace

void sweepPairs(const CycleSetup& setup, const RefineStore& memory, const RefineWork& refined,
                SweepWork& work, PairDistances& distances) noexcept {
  const Sweeping all{setup, memory, refined, work, distances};
  for (const SweepTask& task : work.tasks) {
    work.task_of[task.pair] = kNone;
  }
  work.tasks.clear();
  work.swept = work.left = 0;
  const std::uint32_t budget = budgetOf(refined);
  work.budget = budget - std::min(budget, static_cast<std::uint32_t>(refined.work_done));
  work.work_done = 0;
  distances.passed.clear();
  for (const PairDistance& distance : distances.pairs) {
    if (mayHaveMet(all, distance)) {
      sweepDistance(all, distance);
    }
  }
  std::sort(work.tasks.begin(), work.tasks.end(), [](const SweepTask& x, const SweepTask& y) {
    return std::tie(x.from, x.pair) < std::tie(y.from, y.pair);
  });
  for (SweepTask& task : work.tasks) {
    sweepTask(all, task);
  }
}

}  // namespace collision_monitor
