// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "ros_edge/services/check_trajectory.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {

/// base and tool are 0.3 m + slide + reach apart; see edge_scene.h.
class CheckTrajectoryScene : public testing::Test {
 protected:
  CheckTrajectory::Response ask() {
    CheckTrajectory::Response response;
    answerCheckTrajectory(*setup_, newest_, {}, request_, response);
    return response;
  }
  void addPoint(double time, double position) {
    request_.trajectory.points.emplace_back();
    request_.trajectory.points.back().time_from_start = ros::Duration(time);
    request_.trajectory.points.back().positions = {position};
  }
  static const LinkApproach* find(const CheckTrajectory::Response& response, const std::string& a,
                                  const std::string& b) {
    for (const LinkApproach& pair : response.pairs) {
      if (pair.nearest.link_a == a && pair.nearest.link_b == b) {
        return &pair;
      }
    }
    return nullptr;
  }

  std::shared_ptr<const MonitorSetup> setup_ = slidingSetup();
  NewestState newest_{slidingPoses(setup_->setup.model, 0.0, 0.25),
                      makeNewestState(setup_->setup.model).positions};
  CheckTrajectory::Request request_;
};

}  // namespace collision_monitor::test
