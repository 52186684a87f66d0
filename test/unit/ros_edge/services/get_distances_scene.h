// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "ros_edge/services/get_distances.h"
#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test {

class GetDistancesScene : public testing::Test {
 protected:
  GetDistances::Response ask() {
    GetDistances::Response response;
    const NewestState newest = newestAt(setup_->setup.model, poses_);
    answerGetDistances(*setup_, newest, request_, response);
    return response;
  }
  void move(const std::string& joint, double position) {
    request_.joints.name.push_back(joint);
    request_.joints.position.push_back(position);
  }
  void lose(const std::string& link) {
    poses_.status[index(linkNamed(setup_->setup.model, link))] = LinkStatus::stale;
  }
  /// NaN if the pair is not in the answer.
  static double distanceOf(const GetDistances::Response& response, const std::string& a,
                           const std::string& b) {
    for (const LinkDistance& pair : response.distances.pairs) {
      if (pair.link_a == a && pair.link_b == b) {
        return pair.distance;
      }
    }
    return std::nan("");
  }

  std::shared_ptr<const MonitorSetup> setup_ = slidingSetup();
  LinkPoses poses_ = slidingPoses(setup_->setup.model, 0.0, 0.25);
  GetDistances::Request request_;
};

}  // namespace collision_monitor::test
