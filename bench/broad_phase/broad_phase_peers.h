// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "broad_phase_scene.h"

namespace collision_monitor::bench {

/// A method that finds pairs of boxes, frame by frame.
class Contender {
 public:
  Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;
  virtual ~Contender() = default;

  /// Converts the boxes to the form that run() starts from; not timed.
  virtual void prepare(const BodyBounds& bounds) = 0;
  /// @return number of pairs found.
  virtual std::size_t run() = 0;
};

struct NamedContender {
  std::string name;
  std::unique_ptr<Contender> contender;
};

/// FCL's and Bullet's broad phases, built for the boxes of the scene's first frame.
std::vector<std::string> peerNames();
std::unique_ptr<Contender> makePeer(const std::string& name, const BoxScene& scene);

}  // namespace collision_monitor::bench
