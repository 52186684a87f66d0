// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "merge_srdf.h"

namespace collision_monitor::pairs_tool {

/// Robot "r" with the links a, b, c, d and what was found of their pairs.
struct SrdfScene {
  RobotModel model;
  std::vector<PairFound> pairs;
  PairLines lines{{{"a", "b", "Adjacent"}, {"c", "d", "Never"}}, {{"b", "c", "Never"}}};

  SrdfScene() {
    model.robots.push_back({"r", "", LinkId{0}, 0, 4, 0, 0});
    for (const char* name : {"a", "b", "c", "d"}) {
      model.links.emplace_back().name = name;
    }
    Joint& joint = model.joints.emplace_back();
    joint.name = "elbow";
    model.variable_count = 1;
    add(0, 1, PairFinding::adjacent);
    add(0, 2, PairFinding::sometimes);
    add(0, 3, PairFinding::unclear);
    add(1, 2, PairFinding::never);
    add(1, 3, PairFinding::sometimes);
    add(2, 3, PairFinding::never, true);
  }
  void add(std::uint32_t a, std::uint32_t b, PairFinding finding, bool is_proven = false) {
    PairFound pair{LinkId{a}, LinkId{b}, finding, is_proven};
    pair.joints = {JointId{0}};
    pair.touching = {0.5};
    pairs.push_back(pair);
  }
  SrdfMerge merge(const std::string& srdf) const { return mergeSrdf(srdf, model, pairs, lines); }
};

/// `text` with every `from` as `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// disable_collisions of two links; the reason is that of the pair in SrdfScene::lines.
inline std::string disable(const std::string& a, const std::string& b, const std::string& reason) {
  return R"(<disable_collisions link1=")" + a + R"(" link2=")" + b + R"(" reason=")" + reason +
         R"("/>)";
}

}  // namespace collision_monitor::pairs_tool
