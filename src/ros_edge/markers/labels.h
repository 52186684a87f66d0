// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "collision_monitor/geometry/bounds.h"
#include "ros_edge/markers/snapshot.h"

/// The texts beside distance lines: which pairs get one, what it says and where it stands.
namespace collision_monitor {

constexpr double kTextHeight = 0.03;  ///< [m] of a capital letter

/// The pairs that get a label, at most `most`: those that are not clear, the most urgent first, and
/// where there is room the closest of all, if it is clear. Contacts come before warnings, deep ones
/// first; warnings by their time to contact, then by distance.
std::vector<LinkPairIndex> chooseLabelled(const Watch& watch, std::size_t most);

/// Two lines: "35 mm" and "hand - object table". Format: docs/interfaces.md.
std::string labelText(const CycleSetup& setup, const Snapshot::Label& label);

/// Places texts so that nothing hides them from a viewer who stands on any side and looks down by
/// 30 degrees or more. Frame: that of the texts. Units: m.
class LabelPlaces {
 public:
  /// Takes a free place for a text: `wanted`, or one above what would hide it, other texts too.
  /// @param solids boxes around whatever is not a text; those that end more than 1 m above `wanted`
  /// do not count, since walls and rooms would carry all texts away
  Eigen::Vector3d take(const Eigen::Vector3d& wanted, const std::string& text,
                       const std::vector<Aabb>& solids);
  void clear() { taken_.clear(); }

 private:
  struct Taken {
    Eigen::Vector3d place;
    double width{0.0};
    double height{0.0};
  };
  static void raise(const std::vector<Aabb>& solids, double most, Taken& text);
  /// Null: none is.
  const Taken* inTheWayOf(const Taken& text) const;

  std::vector<Taken> taken_;
};

}  // namespace collision_monitor
