// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/pair_proof.h"

#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

enum class CellState : unsigned char { proven, open, refuted };

/// One cell of one proof.
struct CellTask {
  ProofTools& tools;
  PairProof& proof;
  PlacedCell& placed;
  double rounding;

  const CycleSetup& setup() const noexcept { return tools.measures.setup; }
  ElementPairIndex firstPair() const noexcept {
    return tools.measures.first_element_pair[proof.pair];
  }
  Pose placeOf(const Element& element) const {
    return placed.world_from_link[index(element.link)] * element.link_from_element;
  }
};

Ball placed(const Ball& ball, const Pose& world_from_link) noexcept {
  return {world_from_link * ball.center, ball.radius};
}

/// How far joints move what is in these balls of the two links.
void findLevers(CellTask& task, const Ball& a, const Ball& b) {
  const std::vector<Pose>& poses = task.placed.world_from_link;
  findLevers(task.placed, placed(a, poses[index(task.proof.motion.a)]),
             placed(b, poses[index(task.proof.motion.b)]), task.tools.levers);
}

const ConvexGeometry* hullOf(const Element& element) noexcept {
  return element.convex ? &*element.convex : element.hull ? &*element.hull : nullptr;
}

/// Notes what each variable does, by levers.
void addShares(CellTask& task) {
  std::vector<double>& shares = task.tools.shares;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = std::max(shares[i], shareOf(task.placed, task.tools.levers, i));
  }
}

/// Notes what each variable does to the gap along a normal.
void addShares(CellTask& task, std::size_t split) {
  std::vector<double>& shares = task.tools.shares;
  std::vector<double>& of_variable = task.tools.first_order;
  addCurvatures(task.placed, task.tools.levers, split, of_variable);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = std::max(shares[i], of_variable[i]);
  }
}

/// Asks the hulls of two elements.
/// @param gap [m] the least distance of hulls in the middle, where it is measured
bool areHullsApart(CellTask& task, ElementPairIndex pair, double& gap) {
  ProofTools& tools = task.tools;
  const ElementPair& elements = task.setup().element_pairs[pair];
  const Element& a = task.setup().elements[index(elements.a)];
  const Element& b = task.setup().elements[index(elements.b)];
  const Curvature curvature = curvatureOf(task.placed, tools.levers);
  const ConvexGeometry* const hull_a = hullOf(a);
  const ConvexGeometry* const hull_b = hullOf(b);
  ConvexSearch search{tools.workspace, tools.warm[pair - task.firstPair()]};
  const ConvexDistance found =
      hull_a == nullptr || hull_b == nullptr
          ? ConvexDistance()
          : signedDistanceBetween(*hull_a, task.placeOf(a), *hull_b, task.placeOf(b), search);
  gap = found.quality == Quality::unknown ? -kInfinity
                                          : found.measured.distance - a.padding - b.padding;
  if (!(gap > task.rounding)) {
    addShares(task);
    return false;
  }
  if (gap > tools.levers.travel + task.rounding) {
    return true;
  }
  const double least = gapAlong(task.placed, found.measured.normal_a_to_b, curvature,
                                tools.covers[index(elements.a)].hull,
                                tools.covers[index(elements.b)].hull, tools.first_order);
  if (least > task.rounding) {
    return true;
  }
  addShares(task, curvature.split);
  return false;
}

/// Whether two elements are apart in the whole cell.
CellState apartState(CellTask& task, ElementPairIndex pair) {
  ProofTools& tools = task.tools;
  const ElementPair& elements = task.setup().element_pairs[pair];
  const ElementCover& a = tools.covers[index(elements.a)];
  const ElementCover& b = tools.covers[index(elements.b)];
  if (areBallsApart(task.placed, a.balls, b.balls, task.rounding, tools.sweep)) {
    return CellState::proven;
  }
  findLevers(task, a.ball, b.ball);
  const PairDistance& bodies = tools.measures.nearest_bodies[pair - task.firstPair()];
  const double far_enough = tools.levers.travel + task.rounding;
  double gap = 0.0;
  if (bodies.measured.distance > far_enough || areHullsApart(task, pair, gap)) {
    return CellState::proven;
  }
  constexpr double kMore = 1e-6;  // [m] above what is needed, and above the threshold of touchOf
  const bool has_mesh = !task.setup().elements[index(elements.a)].convex ||
                        !task.setup().elements[index(elements.b)].convex;
  if (gap > task.rounding && !has_mesh) {
    return CellState::open;
  }
  tools.measures.outside = kInfinity;
  const PairDistance found = elementPairDistance(tools.measures, pair, bodies,
                                                 task.placed.world_from_link, far_enough + kMore);
  const Touch touch = gap > task.rounding ? Touch::apart : touchOf(found);
  if (touch != Touch::apart) {
    task.proof.found = touch;
    return CellState::refuted;
  }
  const double distance = std::min(found.measured.distance, tools.measures.outside);
  return distance > far_enough ? CellState::proven : CellState::open;
}

CellState apartState(CellTask& task, JointCell& cell) {
  measureBodies(task.tools.measures, task.proof.pair, task.placed.world_from_link);
  std::vector<std::uint32_t> still_open;
  for (const std::uint32_t pair : cell.open) {
    const CellState state = apartState(task, pair);
    if (state == CellState::refuted) {
      return state;
    }
    if (state == CellState::open) {
      still_open.push_back(pair);
    }
  }
  cell.open = std::move(still_open);
  return cell.open.empty() ? CellState::proven : CellState::open;
}

/// Whether two convex geometries that lie in the elements overlap in the whole cell.
bool doOverlap(CellTask& task, const InnerConvex& a, const InnerConvex& b) {
  findLevers(task, a.ball, b.ball);
  const std::vector<Pose>& poses = task.placed.world_from_link;
  ConvexWarmStart warm;
  ConvexSearch search{task.tools.workspace, warm};
  const ConvexDistance found = signedDistanceBetween(
      a.geometry, poses[index(task.proof.motion.a)] * a.link_from_geometry, b.geometry,
      poses[index(task.proof.motion.b)] * b.link_from_geometry, search);
  constexpr double kDepthError = 1e-6;  // [m] more than a depth may be wrong by
  return found.quality == Quality::exact &&
         -found.measured.distance > task.tools.levers.travel + task.rounding + kDepthError;
}

/// Whether two links touch in the whole cell.
CellState touchingState(CellTask& task, const JointCell& cell) {
  for (const std::uint32_t pair : cell.open) {
    const ElementPair& elements = task.setup().element_pairs[pair];
    for (const InnerConvex& a : task.tools.covers[index(elements.a)].inner) {
      for (const InnerConvex& b : task.tools.covers[index(elements.b)].inner) {
        if (doOverlap(task, a, b)) {
          return CellState::proven;
        }
        addShares(task);
      }
    }
  }
  const Touch touch =
      touchOf(elementDistance(task.tools.measures, task.proof.pair, task.placed.world_from_link));
  task.proof.found = touch;
  return touch == Touch::apart ? CellState::refuted : CellState::open;
}

/// Cuts a cell into halves, or keeps it if it cannot be cut.
void cut(const JointCell& cell, const std::vector<double>& shares, PairProof& proof) {
  const auto most = std::max_element(shares.begin(), shares.end());
  if (most == shares.end() || *most <= 0.0) {
    proof.open.push_back(cell);
    proof.is_stuck = true;
    return;
  }
  const auto variable = static_cast<std::size_t>(most - shares.begin());
  proof.open.push_back(halfOf(cell, variable, -1.0));
  proof.open.push_back(halfOf(cell, variable, 1.0));
}

double marginOf(const ProofTools& tools, const PairMotion& motion) noexcept {
  const Ball& a = tools.measures.balls[index(motion.a)];
  const Ball& b = tools.measures.balls[index(motion.b)];
  return roundingOf(motion.scale + a.center.norm() + a.radius + b.center.norm() + b.radius);
}

void visitCell(ProofTools& tools, PlacedCell& placed, PairProof& proof) {
  JointCell cell = std::move(proof.open.back());
  proof.open.pop_back();
  ++proof.cells;
  place(tools.measures.setup.model, cell, placed);
  tools.shares.assign(proof.motion.ranges.size(), 0.0);
  CellTask task{tools, proof, placed, marginOf(tools, proof.motion)};
  const CellState state = proof.of_touching ? touchingState(task, cell) : apartState(task, cell);
  if (state == CellState::refuted) {
    proof.state = ProofState::refuted;
    proof.at = placed.state;
    proof.open.clear();
  } else if (state == CellState::open) {
    cut(cell, tools.shares, proof);
  }
}

}  // namespace

void forgetPair(ProofTools& tools, LinkPairIndex pair) {
  const ElementPairIndex first = tools.measures.first_element_pair[pair];
  const ElementPairIndex last = tools.measures.first_element_pair[pair + 1];
  tools.warm.assign(last - first, {});
  for (ElementPairIndex elements = first; elements < last; ++elements) {
    const ElementPair& pair_of = tools.measures.setup.element_pairs[elements];
    if (!tools.measures.setup.elements[index(pair_of.a)].is_body ||
        !tools.measures.setup.elements[index(pair_of.b)].is_body) {
      forget(tools.measures.memory.of(elements));
    }
  }
}

PairProof beginProof(const CycleSetup& setup, LinkPairIndex pair, PairMotion motion,
                     const std::vector<Pose>& world_from_root) {
  PairProof proof;
  proof.pair = pair;
  proof.world_from_root = world_from_root;
  for (const LinkId link : {motion.a, motion.b}) {
    motion.scale += world_from_root[index(setup.model.link(link).robot)].translation.norm();
  }
  if (motion.is_whole) {
    JointCell cell = wholeCell(motion);
    for (std::size_t i = 0; i < setup.element_pairs.size(); ++i) {
      if (setup.element_pairs[i].link_pair == pair) {
        cell.open.push_back(static_cast<std::uint32_t>(i));
      }
    }
    proof.open.push_back(std::move(cell));
  }
  proof.motion = std::move(motion);
  return proof;
}

void advance(ProofTools& tools, std::size_t most_cells, Deadline deadline, PairProof& proof) {
  constexpr std::size_t kCellsByClock = 64;
  const RobotModel& model = tools.measures.setup.model;
  if (!isUnderWay(proof)) {
    return;
  }
  forgetPair(tools, proof.pair);
  PlacedCell placed = makePlacedCell(model, proof.motion, proof.world_from_root);
  bool is_over = false;
  while (isUnderWay(proof) && proof.cells < most_cells && !is_over) {
    visitCell(tools, placed, proof);
    is_over = proof.cells % kCellsByClock == 0 && std::chrono::steady_clock::now() > deadline;
  }
  if (proof.state == ProofState::open && proof.open.empty()) {
    proof.state = ProofState::proven;
  }
}

}  // namespace collision_monitor
