// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <utility>
#include <vector>

#include "robot.h"

/// Answers as Python holds them. Each shares the robot, whose names it shows.
namespace collision_monitor::python {

/// One pair of links.
struct PairAnswer {
  SharedRobot robot;
  MeasuredPair pair;
};

struct ContactAnswer : PairAnswer {
  std::vector<Eigen::Vector3d> points;
};

struct PathPairAnswer : PairAnswer {
  ApproachState state{ApproachState::unknown};
  double time{0.0};
  double at_least{0.0};
};

/// All pairs of one state.
struct DistancesAnswer {
  SharedRobot robot;
  std::vector<MeasuredPair> pairs;
  std::vector<double> gradients;
  bool has_gradients{false};
};

/// The names of the links of a pair. @pre pair is not kNone
std::pair<std::string, std::string> linksOf(const Robot& robot, std::uint32_t pair);

/// "hand - forearm: 0.0312 m (exact, warning)"
std::string pairText(const Robot& robot, const MeasuredPair& pair);

/// A length or time with at most five digits.
std::string numberText(double number);

/// The index that Python means: negative ones count from the end.
/// @throws pybind11::index_error
std::size_t indexIn(pybind11::ssize_t given, std::size_t size);

}  // namespace collision_monitor::python
