// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "ros_edge/outputs/conversions.h"
#include "ros_edge/poses/newest_state.h"
#include "ros_edge/watch.h"

namespace collision_monitor::test {

/// A robot with known answers, all from cubes of 0.2 m:
///   base - slider (far below): joint "slide" along x
///   slider - tool, 0.5 m ahead in x: joint "reach" along x
///   slider - finger, 1 m aside in y: joint "follow" along x, 2 * slide + 0.1
/// and an antenna without geometry on the base.
/// base to tool: 0.3 + slide + reach. base to finger: 0.8 while 3 * slide + 0.1 is within 0.2.
/// Checked pairs: base and tool, base and finger, tool and finger.
std::shared_ptr<const MonitorSetup> slidingSetup(const SetupOptions& options = SetupOptions());

/// All links known, with the stamp 12.5 s.
LinkPoses slidingPoses(const RobotModel& model, double slide, double reach);

/// The newest state with these poses, as a service gets it. The reason for unknown links is a
/// missing transform.
NewestState newestAt(const RobotModel& model, const LinkPoses& poses);

/// The slider floats with all that is on it, tool and finger: checked are its pair of these two and
/// two pairs with the base. Poses are as seen from the slider.
void floatSlider(const RobotModel& model, LinkPoses& poses);

/// A watch that has judged these poses once.
std::unique_ptr<Watch> judged(const std::shared_ptr<const MonitorSetup>& setup,
                              const TransformStore& store, const LinkPoses& poses);

/// base and tool overlap by 4 cm, of which limits allow 10; but that is an estimate.
std::unique_ptr<Watch> estimatedDepth(const TransformStore& store);

LinkId linkNamed(const RobotModel& model, const std::string& name);

/// The sliding robot, watched with its slide at 0.
class EdgeScene : public testing::Test {
 protected:
  /// base and tool are 0.3 m + reach apart.
  std::unique_ptr<Watch> watchAt(double reach) {
    return judged(setup_, store_, slidingPoses(setup_->setup.model, 0.0, reach));
  }
  static CycleFacts facts() {
    CycleFacts facts;
    facts.now = ros::Time(13.0);
    return facts;
  }
  static State stateOf(const Watch& watch, const CycleFacts& facts) {
    State state;
    toMessage(watch, facts, state);
    return state;
  }

  TransformStore store_;
  std::shared_ptr<const MonitorSetup> setup_ = slidingSetup();
};

}  // namespace collision_monitor::test
