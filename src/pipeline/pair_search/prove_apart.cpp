// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/prove_apart.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace collision_monitor {
namespace {

constexpr std::size_t kMostVariables = 3;

/// By variable: the center of a cell of joint values, and its half width.
struct Cell {
  std::array<double, kMostVariables> middle{};
  std::array<double, kMostVariables> half{};
};

/// What all cells share.
struct Proof {
  LinkPairMeasures& measures;
  LinkPairIndex pair;
  LinkChain chain;
  std::vector<std::size_t> moving;  ///< indices of ranges
  std::vector<std::size_t> variables;
  JointPositions state;
  std::vector<double> travels;  ///< by range
  std::vector<Pose> roots;
  std::vector<Pose> world_from_link;
};

/// Whether a planar or floating joint moves one link relative to the other.
bool isMovedFreely(const RobotModel& model, LinkId a, LinkId b) {
  // By LinkId: how many of the two links it carries.
  std::vector<int> carries(model.links.size(), 0);
  for (LinkId link : {a, b}) {
    ++carries[index(link)];
    while (const auto& joint = model.link(link).parent_joint) {
      link = model.joint(*joint).parent;
      ++carries[index(link)];
    }
  }
  return std::any_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
    return freedomOf(joint) > 1 && carries[index(joint.child)] == 1;
  });
}

/// Whether the ranges cover all motion of a chain. A joint that mimics a continuous one does not
/// repeat where that one does, unless both turn by the same angle.
bool isWhole(const RobotModel& model, const LinkChain& chain,
             const std::vector<JointRange>& ranges) {
  return std::all_of(chain.joints.begin(), chain.joints.end(), [&](const ChainJoint& joint) {
    const JointRange& range = ranges[joint.path_joint];
    const bool is_continuous = model.joint(range.joint).type == JointType::continuous;
    const bool turns_as_far = !joint.is_prismatic && joint.factor == 1.0;
    return range.is_whole && (!is_continuous || turns_as_far);
  });
}

void place(const Cell& cell, Proof& proof) {
  for (std::size_t i = 0; i < proof.moving.size(); ++i) {
    proof.state[proof.variables[i]] = cell.middle[i];
    proof.travels[proof.moving[i]] = cell.half[i];
  }
  placeLinks(proof.measures.setup.model, proof.state, proof.roots, proof.world_from_link);
}

double boundOf(const Proof& proof, const std::vector<double>& travels) noexcept {
  return boundMotion(proof.chain, proof.measures.balls, proof.world_from_link, travels);
}

/// Whether the links are apart in the whole placed cell. `touch` is the result at its center, if
/// geometries were measured.
bool isApart(Proof& proof, Touch& touch) {
  const double travel = boundOf(proof, proof.travels);
  touch = Touch::apart;
  if (ballDistance(proof.measures, proof.pair, proof.world_from_link) > travel ||
      bodyDistance(proof.measures, proof.pair, proof.world_from_link).measured.distance > travel) {
    return true;
  }
  constexpr double kMore = 1e-6;  // [m] above the travel, and above the threshold of touchOf
  const PairDistance distance =
      elementDistance(proof.measures, proof.pair, proof.world_from_link, travel + kMore);
  touch = touchOf(distance);
  return touch == Touch::apart &&
         std::min(distance.measured.distance, proof.measures.outside) > travel;
}

/// The variable that moves the links most; the cell is cut across it.
std::size_t widestOf(const Proof& proof) {
  std::size_t widest = 0;
  double farthest = -1.0;
  for (std::size_t i = 0; i < proof.moving.size(); ++i) {
    std::vector<double> travels(proof.travels.size(), 0.0);
    travels[proof.moving[i]] = proof.travels[proof.moving[i]];
    const double travel = boundOf(proof, travels);
    if (travel > farthest) {
      farthest = travel;
      widest = i;
    }
  }
  return widest;
}

void search(std::vector<Cell> open, std::size_t most_cells, Proof& proof, ApartProof& answer) {
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    place(cell, proof);
    Touch touch = Touch::apart;
    ++answer.cells;
    if (isApart(proof, touch)) {
      continue;
    }
    if (touch != Touch::apart) {
      answer.found = touch;
      answer.state = proof.state;
      return;
    }
    if (proof.moving.empty() || answer.cells + open.size() >= most_cells) {
      return;
    }
    const std::size_t widest = widestOf(proof);
    for (const double side : {-0.5, 0.5}) {
      Cell half = cell;
      half.half[widest] *= 0.5;
      half.middle[widest] += side * cell.half[widest];
      open.push_back(half);
    }
  }
  answer.is_proven = true;
}

}  // namespace

Touch touchOf(const PairDistance& distance) noexcept {
  constexpr double kTouch = 1e-9;  // [m]
  if (distance.quality == Quality::estimate) {
    return Touch::touching;
  }
  if (distance.quality != Quality::unknown && distance.measured.distance > kTouch) {
    return Touch::apart;
  }
  return distance.quality == Quality::exact ? Touch::touching : Touch::unclear;
}

LinkChain chainOf(const RobotModel& model, const std::vector<JointRange>& ranges, LinkId a,
                  LinkId b) {
  JointPath path;
  for (const JointRange& range : ranges) {
    path.joints.push_back(range.joint);
  }
  return chainBetween(model, path, a, b);
}

ApartProof proveApart(LinkPairMeasures& measures, LinkPairIndex pair,
                      const std::vector<JointRange>& ranges, std::size_t most_cells) {
  const RobotModel& model = measures.setup.model;
  const CheckedLinkPair& links = measures.setup.checked[pair];
  Proof proof{measures, pair, chainOf(model, ranges, links.a, links.b), {}, {}, {}, {}, {}, {}};
  for (const ChainJoint& joint : proof.chain.joints) {
    if (std::find(proof.moving.begin(), proof.moving.end(), joint.path_joint) ==
        proof.moving.end()) {
      proof.moving.push_back(joint.path_joint);
    }
  }
  ApartProof answer;
  if (proof.moving.size() > kMostVariables || !isWhole(model, proof.chain, ranges) ||
      isMovedFreely(model, links.a, links.b)) {
    return answer;
  }
  Cell all;
  for (std::size_t i = 0; i < proof.moving.size(); ++i) {
    const JointRange& range = ranges[proof.moving[i]];
    proof.variables.push_back(model.joint(range.joint).first_variable);
    all.middle[i] = 0.5 * (range.lower + range.upper);
    all.half[i] = 0.5 * (range.upper - range.lower);
  }
  proof.state = defaultPositions(model);
  proof.travels.resize(ranges.size(), 0.0);
  proof.roots.resize(model.robots.size());
  search({all}, most_cells, proof, answer);
  return answer;
}

}  // namespace collision_monitor
