// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "broad_phase/broad_phase.h"
#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/twist.h"
#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/narrow_phase/signed_distance.h"
#include "collision_monitor/pipeline/element.h"
#include "collision_monitor/pipeline/pair_blocks.h"
#include "collision_monitor/pipeline/verdict.h"
#include "motion/conservative_advancement.h"
#include "pipeline/data/distances_kept.h"
#include "pipeline/data/moved_parts.h"
#include "pipeline/data/placed_links.h"
#include "pipeline/data/refine_store.h"

/// The data between the stages of a cycle: plain arrays sized at set-up. World frame, metres,
/// seconds. Data carry ids; names appear only at the ROS edge.
namespace collision_monitor {

enum class LinkStatus : unsigned char {
  known,
  stale,         ///< its newest pose is older than max_age
  missing,       ///< no pose was ever received, or it cannot be joined to the world
  not_finite,    ///< the pose holds NaN or infinity, or its rotation is not rigid
  contradicted,  ///< two sources disagree about the same time
};

/// The velocities of the links, where they are known.
struct LinkVelocities {
  std::vector<Twist> of_link;        ///< by LinkId
  std::vector<unsigned char> known;  ///< by LinkId
};

/// The poses of all links, with one stamp for the known links of each robot.
///
/// A part begins to float at a link whose pose relative to its parent link (for a root: to the
/// world) is unknown. The part holds the links from there on that are known beside each other. Its
/// frame is that of its top link, which has the identity pose and zero velocity. Relative poses of
/// links of two parts mean nothing.
struct LinkPoses {
  std::int64_t stamp_ns{0};                  ///< the oldest of the robots' stamps
  std::vector<std::int64_t> robot_stamp_ns;  ///< by RobotId; 0: none yet
  std::vector<Pose> world_from_link;         ///< in a part that floats: top_from_link
  std::vector<LinkStatus> status;            ///< within its part
  std::vector<PartId> part;                  ///< by LinkId
  /// By LinkId: why its part is not joined to what is above; `known` in the world's part.
  std::vector<LinkStatus> part_status;
  std::vector<double> age;  ///< [s] within its part; 0 for links that only static transforms place
  LinkVelocities velocities;  ///< relative to the frame of the part
};

/// Whether the relative pose of two links is known.
inline bool isJoined(const LinkPoses& poses, LinkId a, LinkId b) noexcept {
  return poses.status[index(a)] == LinkStatus::known &&
         poses.status[index(b)] == LinkStatus::known &&
         poses.part[index(a)] == poses.part[index(b)];
}

/// `known`, or why the pose of a link in the world is not known.
inline LinkStatus statusInWorld(const LinkPoses& poses, LinkId link) noexcept {
  const LinkStatus status = poses.status[index(link)];
  return status == LinkStatus::known ? poses.part_status[index(link)] : status;
}

/// Begins a part that floats at this link.
inline void floatFrom(std::size_t link, LinkStatus reason, LinkPoses& poses) noexcept {
  poses.world_from_link[link] = Pose();
  poses.status[link] = LinkStatus::known;
  poses.part[link] = static_cast<PartId>(link);
  poses.part_status[link] = reason;
  poses.age[link] = 0.0;
}

/// Makes poses for the model: all links `missing`, in the world's part, velocities unknown.
LinkPoses makeLinkPoses(const RobotModel& model);

struct BodyPoses {
  MovedParts moved;  ///< all, unless findResting left some out
  std::vector<Pose> world_from_body;
  std::vector<Ball> balls;  ///< bounding balls, world frame; contiguous for culling
  BodyRows rows;            ///< body poses in columns, NaN where a body is not known
  std::vector<unsigned char> known;
  /// By LinkId, of links with bodies: known, rigid and not the only link of a part that floats.
  std::vector<unsigned char> link_known;
  std::vector<PartId> part;                  ///< by LinkId
  bool is_split{false};                      ///< known links with bodies are in several parts
  std::vector<std::uint32_t> links_of_part;  ///< by top link: scratch
  std::vector<Pose> world_from_element;      ///< by ElementId, of known links
};

/// Whether bodies of these links can be measured against each other.
inline bool isJoined(const BodyPoses& poses, LinkId a, LinkId b) noexcept {
  return poses.link_known[index(a)] != 0 && poses.link_known[index(b)] != 0 &&
         poses.part[index(a)] == poses.part[index(b)];
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// What a distance is measured between, the finest last.
enum class Detail : unsigned char {
  shapes,      ///< enclosing shapes
  elements,    ///< hulls or padded geometries, or a lower bound that a search proved
  geometries,  ///< the geometries of the URDF themselves
};

struct PairDistance {
  PairId pair{};
  Quality quality{Quality::unknown};
  bool is_refined{false};  ///< measured between elements; these bodies are their nearest
  SignedDistance measured;
  double closing_speed{kUnknown};    ///< [m/s] at the witness points; > 0: the distance shrinks
  double time_to_contact{kUnknown};  ///< [s] as timeToContact, until contact_distance
  bool is_raised{false};  ///< not refined, but a search proved this lower bound for the elements
  /// [m] > 0: the geometries were not measured in this cycle, and are at most this much farther
  /// apart than `measured` says.
  double shortfall{0.0};
};

inline Detail detailOf(const PairDistance& distance) noexcept {
  if (distance.quality != Quality::lower_bound) {
    return Detail::geometries;
  }
  return distance.is_refined || distance.is_raised ? Detail::elements : Detail::shapes;
}

/// An estimate is a contact even if limits allow some depth: the true depth may be larger.
inline bool isTouching(const PairDistance& distance, double contact_distance) noexcept {
  return distance.quality == Quality::estimate || distance.measured.distance <= contact_distance;
}

inline bool comesNearer(const PairDistance& one, const PairDistance& other) noexcept {
  return one.measured.distance < other.measured.distance;
}

/// A contact between the last cycle and this one, of links that are apart in both.
struct PassedContact {
  double time{0.0};  ///< share of the motion from the last poses to these, 0 .. 1
  /// At that time. exact: the geometries touched; lower_bound: enclosing shapes touched, so the
  /// geometries may have.
  PairDistance distance;
  Pose world_from_link_a;  ///< at that time
  Pose world_from_link_b;
};

/// The distances of a cycle, in `pairs` sorted by pair id. They hold every pair that matters to a
/// verdict, a time or the speed scale; the nearest bodies of any two elements within the activation
/// distance, of lone bodies only the nearest of two links; and always the closest pair. A refined
/// pair of elements has one entry, that of its nearest bodies.
struct PairDistances {
  std::vector<PairDistance> pairs;
  std::vector<PassedContact> passed;
};

using LinkPairIndex = std::uint32_t;  ///< into CycleSetup::checked

struct VerdictChange {
  LinkPairIndex link_pair{0};
  Verdict before{Verdict::clear};
  Verdict after{Verdict::clear};
};

/// The verdicts of all checked link pairs.
struct PairEvents {
  /// The pairs that a cycle looked at, in order. All others are clear and without a distance, or
  /// they stay unknown.
  std::vector<LinkPairIndex> active;
  std::vector<unsigned char> is_active;   ///< by LinkPairIndex: scratch, 0 between two cycles
  std::vector<unsigned char> is_checked;  ///< by LinkId: the link is in a checked pair
  std::size_t unjoined{0};                ///< the number of pairs with an unknown relative pose
  std::size_t unknown{0};                 ///< the number of pairs that are unknown
  /// How often a cycle judged every pair. Which pairs are unknown changes only then.
  std::uint64_t complete_judgements{0};
  std::vector<Verdict> verdicts;  ///< by LinkPairIndex
  /// Pairs that stay a warning, though the cycle passed over some of their bodies: see
  /// SettledPairs.
  std::vector<LinkPairIndex> settled;
  std::vector<unsigned char> is_settled;  ///< by LinkPairIndex
  std::vector<std::uint32_t> closest;     ///< by LinkPairIndex: index into `pairs`, or kNone
  std::vector<std::uint32_t>
      passed;  ///< by LinkPairIndex: index into passed of the first, or kNone
  /// By LinkPairIndex: index into `pairs` of the deepest Quality::estimate, or kNone.
  std::vector<std::uint32_t> estimated;
  /// By LinkPairIndex: index into `pairs` of the pair with the least time to contact, or kNone if
  /// nothing touches within the horizon.
  std::vector<std::uint32_t> soonest;
  /// Changes against the verdict last reported, in order of link pair. A clear pair that becomes
  /// unknown is no change: its unknown links are reported once for all their pairs. A warning or
  /// contact that becomes unknown is a change.
  std::vector<VerdictChange> changes;
  std::vector<std::uint32_t> island_of_link;    ///< by LinkId: 1, 2, ... in contact, 0 for the rest
  std::vector<std::uint32_t> links_of_islands;  ///< those not 0
  std::uint32_t island_count{0};
  std::vector<std::uint32_t> island_forest;  ///< by LinkId: scratch of the grouping
  std::uint32_t closest_of_all{kNone};       ///< index into `pairs`
  /// [s] The least time of all pairs. Infinity if nothing touches within the horizon; unknown if
  /// nothing is known to touch and the time of a pair is unknown.
  double time_to_contact{kUnknown};
  Verdict overall{Verdict::unknown};
};

struct CycleCounters {
  std::size_t pairs{0};       ///< pairs of bodies in the table
  std::size_t candidates{0};  ///< pairs whose bounds met when pairs were last listed
  /// Of the candidates: too far apart by the distance cache, or left out of the list.
  std::size_t culled_by_cache{0};
  std::size_t culled_by_spheres{0};  ///< of the rest: too far apart by bounding spheres
  std::size_t culled_by_boxes{0};    ///< of the rest: apart by oriented boxes; combination only
  std::size_t measured{0};           ///< the rest; without the search for the closest pair
  std::size_t refined{0};            ///< pairs of elements measured completely
  std::size_t left{0};               ///< pairs of elements starved by the budget
  std::size_t refine_work{0};        ///< work done of the budget
  std::size_t swept{0};              ///< pairs whose motion since the last cycle was followed
  std::size_t swept_left{0};         ///< pairs of elements starved by the budget
  std::size_t unknown_pairs{0};      ///< pairs of bodies with an unknown link or of two parts
  std::size_t unknown_links{0};      ///< links with geometry whose pose is unknown
};

/// How long many objects have rested, and their twist then.
struct Rest {
  std::uint32_t cycles{0};
  bool is_twist_known{false};
  Twist twist;
};

/// The poses of the links in the last cycle.
struct LastPoses : PlacedLinks {
  std::int64_t stamp_ns{0};
  std::vector<Rest> rests;  ///< by CycleSetup::carried; 0 cycles whenever the rest is changed
};

/// Whether a link was known in the same part. Otherwise its motion since then is not known.
inline bool hasStayed(const PlacedLinks& last, const BodyPoses& now, std::size_t link) noexcept {
  return last.known[link] != 0 && now.link_known[link] != 0 && last.part[link] == now.part[link];
}

/// The speed scale and its state.
struct SpeedScale {
  double scale{1.0};                   ///< 0 stop .. 1 full speed
  std::int64_t stamp_ns{0};            ///< of the poses that led to `scale`
  std::vector<unsigned char> stopped;  ///< by LinkPairIndex: it closed or touched at stop_distance
                                       ///< and has not parted since
};

/// What survives a cycle. A reset changes hysteresis, which verdicts count as changes, how the
/// speed scale grows, and for refinement its speed, order and depth estimates; contacts since the
/// last cycle are then not found. A reset of the distance cache changes the time a cycle takes.
/// While nobody listens, a scale may then grow a cycle sooner or later, and the nearest pair may
/// have another lower bound beyond refine_distance.
struct PairMemory {
  /// The next cycle looks at every pair: links became known or unknown, or what follows was changed
  /// from outside of a cycle.
  bool judges_all{true};
  /// Pairs that the next cycle looks at whatever their distance: those of isLively, each once or
  /// more often. Means nothing if it looks at every pair.
  std::vector<LinkPairIndex> lively;
  std::vector<Verdict> reported;       ///< by LinkPairIndex: the verdict last reported
  std::vector<Detail> contact_detail;  ///< by LinkPairIndex: the finest detail that showed the
                                       ///< reported contact
  SpeedScale speed;
  RefineStore refined;
  /// By ElementPairIndex: how many cycles in a row the budget starved it.
  std::vector<std::uint32_t> starved_cycles;
  DistanceCache distance_cache;
  LastPoses last;
};

/// Whether anything but `clear` is remembered of a pair's verdict or speed.
inline bool isLively(const PairMemory& memory, LinkPairIndex pair) noexcept {
  return memory.reported[pair] != Verdict::clear || memory.speed.stopped[pair] != 0;
}

}  // namespace collision_monitor
