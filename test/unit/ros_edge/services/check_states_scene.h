// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "ros_edge/services/check_states.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {

class CheckStatesServiceTest : public testing::Test {
 protected:
  CheckStates::Response ask() {
    CheckStates::Response response;
    const NewestState newest = newestAt(setup_->setup.model, poses_);
    answerCheckStates(*setup_, newest, progress_, request_, response);
    return response;
  }

  std::shared_ptr<const MonitorSetup> setup_ = slidingSetup();
  LinkPoses poses_ = slidingPoses(setup_->setup.model, 0.0, 0.25);
  std::function<bool(double)> progress_;
  CheckStates::Request request_;
};

}  // namespace collision_monitor::test
