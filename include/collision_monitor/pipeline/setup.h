// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/model/pair_rules.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/shape_rules.h"
#include "collision_monitor/model/urdf_reader.h"
#include "collision_monitor/motion/speed_scale.h"
#include "collision_monitor/narrow_phase/pair_rows.h"
#include "collision_monitor/pipeline/element.h"
#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/pair_blocks.h"

namespace collision_monitor {

/// Thresholds of the verdicts. Units: metres and seconds.
/// @pre finite; contact_distance <= warning_distance <= report_distance; hysteresis >= 0;
/// 0 <= contact_time <= warning_time; time_hysteresis >= 0.
struct Limits {
  double contact_distance{0.0};   ///< at or below: contact
  double warning_distance{0.05};  ///< at or below: warning
  double hysteresis{0.005};       ///< how far beyond its threshold a verdict is left
  double report_distance{0.2};    ///< pairs at or below are published
  double contact_time{0.0};       ///< a pair that touches this soon is a contact; 0: off
  double warning_time{0.1};       ///< a pair that touches this soon is a warning; 0: off
  double time_hysteresis{0.05};   ///< as hysteresis, for times
};

/// How far ahead a cycle looks, and how the speed scale follows from it.
struct LookAhead {
  double horizon{0.5};  ///< [s] the set-up raises it to what thresholds and rule need
  StopRule stop;
};

/// One enclosing shape, fixed to a link.
struct Body {
  LinkId link{};
  Pose link_from_body;
  Shape shape;
  double bounding_radius{0.0};  ///< [m] about the body's origin
  bool is_exact{false};         ///< the shape is the geometry of the URDF
  ElementId element{};          ///< the element that this body encloses, alone or with others
};

/// What messages and reports say of a body. Never read in a cycle.
struct BodyLabel {
  std::string shape_name;  ///< unique within its link
  Overshoot overshoot;     ///< NaN for given shapes: not measured
  double widening{0.0};    ///< [m]
  bool is_proven{true};    ///< false: given shapes that their link may stick out of
};

/// A checked pair of links. CycleSetup::limits decide the verdicts of all pairs.
struct CheckedLinkPair {
  LinkId a{};
  LinkId b{};
};

/// Pairs [first, last) of the table join these kinds of core, in either order; a <= b.
struct PairRange {
  CoreKind a{};
  CoreKind b{};
  std::size_t first{0};
  std::size_t last{0};
};

/// Everything that stays the same from cycle to cycle. A service that changes something builds a
/// new set-up and swaps it in between two cycles.
struct CycleSetup {
  RobotModel model;
  std::vector<Body> bodies;                 ///< by BodyId, in order of link
  std::vector<Core> cores;                  ///< by BodyId: of its shape, for rows of pairs
  std::vector<BodyLabel> labels;            ///< by BodyId
  std::vector<LinkPair> link_pairs;         ///< all, each with the reason why it is checked or not
  std::vector<CheckedLinkPair> checked;     ///< by LinkPairIndex, sorted by (a, b)
  PairTable table;                          ///< by PairId, ordered by kind of core pair
  std::vector<std::uint32_t> link_pair_of;  ///< by PairId: index into checked
  std::vector<PairRange> ranges;            ///< one for each kind of core pair present
  PairBlocks blocks;              ///< the table again, laid out to measure all pairs of a pose
  std::vector<Element> elements;  ///< by ElementId, in order of link
  std::vector<ElementPair> element_pairs;         ///< by ElementPairIndex, grouped by pair of links
  std::vector<ElementPairIndex> element_pair_of;  ///< by PairId
  Limits limits;
  RefineLimits refine;
  bool is_continuous{false};  ///< contacts between two cycles are searched for
  LookAhead ahead;
  std::vector<std::string> velocity_names;  ///< as velocityNames; never read in a cycle
  SetupReport report;                       ///< warnings only
};

struct SetupOptions {
  /// Stands before the names of options in messages: "parameter /collision_monitor/".
  std::string where;
  Limits limits;
  double padding{0.0};  ///< [m] >= 0; added to the radius or extents of every shape
  FitLimits default_limits{4, 0.01, {}};  ///< of links for which the rules say nothing
  ShapeRulesText shape_rules;
  MeshReading meshes;
  RefineOptions refine;
  bool is_continuous{true};  ///< as in CycleSetup
  LookAhead ahead;
  std::filesystem::path fit_cache;       ///< directory that keeps fits, empty for none
  FitProgress fit_progress;              ///< may be empty
  std::vector<NamedPair> ignored_pairs;  ///< ignored in addition to what SRDFs say
  /// [bytes] What pairs may take, which grows with the square of links; 0: what is available.
  std::uint64_t memory_limit{0};
  bool ignore_default_overlap{
      true};  ///< for robots without SRDF: ignore pairs that overlap in the default pose
};

/// Reads robots, fits links and lists pairs. Reports all problems at once.
/// @throws SetupError
/// @throws Interrupted
CycleSetup buildSetup(const std::vector<RobotDescription>& robots,
                      const ResourceLoader& load_resource, const SetupOptions& options);

/// Adds a problem for each limit that breaks a precondition of Limits.
/// @param where stands before the names of limits in messages
void checkLimits(const Limits& limits, const std::string& where, SetupReport& report);

}  // namespace collision_monitor
