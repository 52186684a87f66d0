// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/model/limits.h"
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

/// How far ahead a cycle looks, and how the speed scale follows from it.
struct LookAhead {
  double horizon{0.5};  ///< [s] the set-up raises it to what thresholds and rule need
  StopRule stop;        ///< how speed is scaled
};

/// One enclosing shape, fixed to a link.
struct Body {
  LinkId link{};                ///< to which it is fixed
  Pose link_from_body;          ///< where its shape stands in the link
  Shape shape;                  ///< with the padding
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

/// A checked pair of links. limitsOf gives the limits that decide its verdict.
struct CheckedLinkPair {
  LinkId a{};               ///< a < b
  LinkId b{};               ///< the other link
  std::uint32_t limits{0};  ///< as LinkPair::limits
};

/// Pairs [first, last) of the table join these kinds of core, in either order; a <= b.
struct PairRange {
  CoreKind a{};          ///< of one body
  CoreKind b{};          ///< of the other body
  std::size_t first{0};  ///< first PairId
  std::size_t last{0};   ///< behind the last PairId
};

/// Many objects that one frame or link carries: their links, bodies and elements, each [first,
/// last). They keep their places to each other, so a cycle skips them while they rest.
struct CarriedObjects {
  std::size_t first_link{0};     ///< LinkId of the first
  std::size_t last_link{0};      ///< one after the last
  std::size_t first_body{0};     ///< BodyId of the first
  std::size_t last_body{0};      ///< one after the last
  std::size_t first_element{0};  ///< ElementId of the first
  std::size_t last_element{0};   ///< one after the last
  bool is_checked{false};        ///< one of the links is in a checked pair
};

/// Everything that stays the same from cycle to cycle. A service that changes something builds a
/// new set-up and swaps it in between two cycles.
struct CycleSetup {
  RobotModel model;                         ///< robots, links and joints
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
  std::vector<CarriedObjects> carried;            ///< in order of link
  Limits limits;                                  ///< of all pairs without limits of their own
  std::vector<OwnLimits> own_limits;              ///< by CheckedLinkPair::limits - 1
  RefineLimits refine;                            ///< what a cycle may spend on elements
  bool is_continuous{false};                      ///< contacts between two cycles are searched for
  LookAhead ahead;  ///< how far forecasts reach, and the rule of the speed scale
  // Never read in a cycle.
  double least_horizon{0.0};      ///< [s] `ahead` has this horizon, or what thresholds of time need
  std::uint64_t memory_limit{0};  ///< as in SetupOptions
  std::vector<std::string> velocity_names;  ///< as velocityNames
  std::vector<SrdfPairs> srdfs;             ///< of each robot that has one
  std::vector<PairRule> pair_rules;         ///< by LinkPair::rule
  SetupReport report;                       ///< warnings only
};

/// The limits of a pair. Most pairs have the common ones.
inline const Limits& limitsOf(const CycleSetup& setup, const CheckedLinkPair& pair) noexcept {
  return pair.limits == 0 ? setup.limits : setup.own_limits[pair.limits - 1].limits;
}

/// @param link_pair index into CycleSetup::checked
inline const Limits& limitsOf(const CycleSetup& setup, std::size_t link_pair) noexcept {
  return setup.own_limits.empty() ? setup.limits : limitsOf(setup, setup.checked[link_pair]);
}

/// The largest value of all limits.
/// @param value takes Limits
template <class Value>
double largestOfLimits(const CycleSetup& setup, const Value& value) noexcept {
  double largest = value(setup.limits);
  for (const OwnLimits& own : setup.own_limits) {
    largest = std::max(largest, value(own.limits));
  }
  return largest;
}

/// The padding of links whose name matches.
struct NamedPadding {
  std::string link;     ///< a name or pattern
  double padding{0.0};  ///< [m] >= 0
};

/// What the user wants of a set-up.
struct SetupOptions {
  /// Stands before the names of options in messages: "parameter /collision_monitor/".
  std::string where;
  Limits limits;        ///< of pairs without limits of their own
  double padding{0.0};  ///< [m] >= 0; added to the radius or extents of every shape
  FitLimits default_limits{4, 0.01, {}};    ///< of links for which the rules say nothing
  DocumentText shape_rules;                 ///< for single links; wins over the options here
  DocumentText pair_rules;                  ///< for pairs; wins over SRDFs and ignored_pairs
  IdleRule idle_rules{IdleRule::is_error};  ///< of `pair_rules`
  bool awaits_names{false};                 ///< as SetupReport, of the other rules
  MeshReading meshes;                       ///< how mesh files are read
  RefineOptions refine;                     ///< to what distances are refined
  bool is_continuous{true};                 ///< as in CycleSetup
  LookAhead ahead;                          ///< as in CycleSetup
  std::filesystem::path fit_cache;          ///< directory that keeps fits, empty for none
  FitProgress fit_progress;                 ///< may be empty
  std::vector<NamedPadding> link_paddings;  ///< of links whose rules give no padding
  /// `<link_sphere_approximation>` of SRDFs replaces fits where rules give no shapes. Whether the
  /// spheres enclose their link is not proven.
  bool uses_srdf_spheres{false};
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

/// The same set-up with other limits and rules for pairs. Bodies and elements are copied, not made
/// anew. Pairs that a rule ignored at start were not looked at in the default pose; without that
/// rule they are checked.
/// @param report gets a warning for each rule that selects no pair.
/// @throws SetupError with every fault: those of the report, limits that break a precondition, or
/// too little memory.
/// @throws Interrupted
CycleSetup withPairRules(const CycleSetup& setup, const Limits& limits,
                         const std::vector<PairRule>& rules, SetupReport& report);

/// Adds the faults for which withPairRules would refuse these limits and rules, and its warnings.
void checkPairRules(const CycleSetup& setup, const Limits& limits,
                    const std::vector<PairRule>& rules, SetupReport& report);

/// The same set-up that checks only these pairs, whatever rules say.
/// @param wanted each pair once, in any order; with the limits of setup.own_limits that they name
/// @throws Interrupted
CycleSetup withPairs(const CycleSetup& setup, std::vector<LinkPair> wanted);

/// Adds a problem for each limit that breaks a precondition of Limits.
/// @param where stands before the names of limits in messages
void checkLimits(const Limits& limits, const std::string& where, SetupReport& report);

}  // namespace collision_monitor
