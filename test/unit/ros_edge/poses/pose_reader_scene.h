// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "ros_edge/poses/pose_reader.h"
#include "support/robots/urdf_text.h"
#include "transform_along_x.h"

namespace collision_monitor::test {

constexpr const char* kCube = "<box size='0.1 0.1 0.1'/>";

/// base -j1- arm -j2- wrist (no geometry) -j3- hand, and base -jc- camera, without geometry.
class PoseReaderTest : public testing::Test {
 protected:
  PoseReaderTest()
      : model_(readText(robotXml(linkXml("base", kCube) + linkXml("arm", kCube) +
                                 "<link name='wrist'/>" + linkXml("hand", kCube) +
                                 "<link name='camera'/>" + joint("j1", "base", "arm") +
                                 joint("j2", "arm", "wrist") + joint("j3", "wrist", "hand") +
                                 joint("jc", "base", "camera")))
                   .model),
        poses_(makeLinkPoses(model_)) {}

  static std::string joint(const char* name, const char* parent, const char* child) {
    return jointXml(name, "continuous", parent, child);
  }

  void send(const std::string& parent, const std::string& child, double stamp, double x) {
    // Data of several publishers arrive in any order; the clock only goes forward.
    now_ = std::max(now_, ros::Time(stamp));
    store_.accept({transformAlongX(parent, child, stamp, x)}, false);
  }
  void sendStatic(const std::string& parent, const std::string& child, double x) {
    store_.accept({transformAlongX(parent, child, 0.0, x)}, true);
  }
  void sendArm(double stamp, double x) {
    send("base", "arm", stamp, x);
    send("arm", "wrist", stamp, x);
    send("wrist", "hand", stamp, x);
  }

  bool read(double now) {
    if (!reader_) {
      reader_ = std::make_unique<PoseReader>(model_, store_, options_);
    }
    now_ = ros::Time(now);
    store_.readTime();
    return reader_->read(ros::Time(now), poses_);
  }

  std::size_t at(const std::string& link) const { return index(*model_.findLink(link)); }
  LinkStatus status(const std::string& link) const {
    return statusInWorld(poses_, *model_.findLink(link));
  }
  double age(const std::string& link) const { return poses_.age[at(link)]; }
  double x(const std::string& link) const {
    return poses_.world_from_link[at(link)].translation.x();
  }
  std::string explain(const std::string& link) const {
    return reader_->explain(*model_.findLink(link));
  }

  RobotModel model_;
  LinkPoses poses_;
  ros::Time now_{0.5};
  TransformStore store_{[this] { return now_; }};
  PoseReaderOptions options_;
  std::unique_ptr<PoseReader> reader_;
};

}  // namespace collision_monitor::test
