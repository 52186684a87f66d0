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
#include "motion/conservative_advancement.h"
#include "pipeline/data/refine_memory.h"

/// What travels from stage to stage of one cycle: plain arrays sized at set-up,
/// world frame, metres and seconds. Ids here, names only at the ROS edge.
namespace collision_monitor {

enum class LinkStatus : unsigned char {
  known,
  stale,         ///< its newest pose is older than max_age
  missing,       ///< no pose was ever received, or it cannot be joined to the world
  not_finite,    ///< the pose holds NaN or infinity, or its rotation is none
  contradicted,  ///< two sources say different things of one time
};

/// How fast the links move, as far as it is known.
struct LinkVelocities {
  std::vector<Twist> of_link;        ///< by LinkId
  std::vector<unsigned char> known;  ///< by LinkId
};

/// Links whose poses are known beside each other: kWorldPart, or the LinkId of the top link of a
/// part that floats.
using PartId = std::uint32_t;
constexpr PartId kWorldPart = 0xffffffffU;  ///< joined to the world

/// One stamp for all links of a robot that are known.
///
/// Where it is not known how a link stands to its parent link, or a root to the world, a part
/// begins that floats: the links from there on, as far as they are known beside each other. Its
/// frame is that of its top link, which stands at the identity, and at rest. Nothing that joins
/// links of two parts means anything.
struct LinkPoses {
  std::int64_t stamp_ns{0};                  ///< the oldest of the robots' stamps
  std::vector<std::int64_t> robot_stamp_ns;  ///< by RobotId; 0: none yet
  std::vector<Pose> world_from_link;         ///< of a part that floats: top_from_link
  std::vector<LinkStatus> status;            ///< known: in its part
  std::vector<PartId> part;                  ///< by LinkId
  /// By LinkId: what keeps its part from being joined to what is above it; known: the world's part.
  std::vector<LinkStatus> part_status;
  std::vector<double> age;    ///< [s] in its part; 0 for a link that only static transforms place
  LinkVelocities velocities;  ///< as seen from the frame of the part
};

/// Whether it is known how two links stand to each other.
inline bool isJoined(const LinkPoses& poses, LinkId a, LinkId b) noexcept {
  return poses.status[index(a)] == LinkStatus::known &&
         poses.status[index(b)] == LinkStatus::known &&
         poses.part[index(a)] == poses.part[index(b)];
}

/// `known`, or why it is not known where a link is in the world.
inline LinkStatus statusInWorld(const LinkPoses& poses, LinkId link) noexcept {
  const LinkStatus status = poses.status[index(link)];
  return status == LinkStatus::known ? poses.part_status[index(link)] : status;
}

/// A part that floats begins at this link.
inline void floatFrom(std::size_t link, LinkStatus reason, LinkPoses& poses) noexcept {
  poses.world_from_link[link] = Pose();
  poses.status[link] = LinkStatus::known;
  poses.part[link] = static_cast<PartId>(link);
  poses.part_status[link] = reason;
  poses.age[link] = 0.0;
}

/// Links all `missing`, in the world's part, their velocities unknown, sized for the model.
LinkPoses makeLinkPoses(const RobotModel& model);

struct BodyPoses {
  std::vector<Pose> world_from_body;
  std::vector<Ball> balls;  ///< that bound the bodies, in the world; next to each other for a cull
  BodyRows rows;            ///< the same in columns, NaN where the body is not known
  std::vector<unsigned char> known;
  /// By LinkId, of links with bodies: known and rigid, and not alone in a part that floats.
  std::vector<unsigned char> link_known;
  std::vector<PartId> part;                  ///< by LinkId
  bool is_split{false};                      ///< known links with bodies stand in several parts
  std::vector<std::uint32_t> links_of_part;  ///< by top link: scratch
  std::vector<Pose> world_from_element;      ///< by ElementId, of known links
};

/// Whether a pair of these links can be measured.
inline bool isJoined(const BodyPoses& poses, LinkId a, LinkId b) noexcept {
  return poses.link_known[index(a)] != 0 && poses.link_known[index(b)] != 0 &&
         poses.part[index(a)] == poses.part[index(b)];
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// What a distance is one of, the finest last.
enum class Detail : unsigned char {
  shapes,      ///< enclosing shapes
  elements,    ///< what stands behind them: hulls, padded geometries, or a bound that a search gave
  geometries,  ///< the geometries of the URDF themselves
};

struct PairDistance {
  PairId pair{};
  Quality quality{Quality::unknown};
  bool is_refined{false};  ///< measured between elements, of which the bodies are the nearest part
  SignedDistance measured;
  double closing_speed{kUnknown};    ///< [m/s] at the two points; > 0: the distance shrinks
  double time_to_contact{kUnknown};  ///< [s] as timeToContact, down to contact_distance
  bool is_raised{false};  ///< not refined: a search proved the elements at least so far apart
};

inline Detail detailOf(const PairDistance& distance) noexcept {
  if (distance.quality != Quality::lower_bound) {
    return Detail::geometries;
  }
  return distance.is_refined || distance.is_raised ? Detail::elements : Detail::shapes;
}

/// An estimate is a contact also where limits allow some depth: it may be deeper than it says.
inline bool isTouching(const PairDistance& distance, double contact_distance) noexcept {
  return distance.quality == Quality::estimate || distance.measured.distance <= contact_distance;
}

/// A contact between the last cycle and this one, of links that are apart in both.
struct PassedContact {
  double time{0.0};  ///< share of the way from the last poses to these
  /// At that time. exact: the geometries touched; lower_bound: what encloses them did, and they may
  /// have.
  PairDistance distance;
  Pose world_from_link_a;  ///< at that time
  Pose world_from_link_b;
};

/// `measured` is sorted by pair id. It holds every pair that matters to a verdict, a time or the
/// speed scale, of each two elements within reach the nearest bodies and, when nothing is near, the
/// closest pair all the same. A refined pair of elements stands once, in place of the nearest of
/// its bodies.
struct PairDistances {
  std::vector<PairDistance> pairs;
  std::vector<PassedContact> passed;
};

/// Ordered by urgency: the state of the whole is the largest of its parts.
enum class Verdict : unsigned char { clear, warning, unknown, contact };

using LinkPairIndex = std::uint32_t;  ///< into CycleSetup::checked

struct VerdictChange {
  LinkPairIndex link_pair{0};
  Verdict before{Verdict::clear};
  Verdict after{Verdict::clear};
};

/// What was judged, for each checked pair of links.
struct PairEvents {
  std::vector<Verdict> verdicts;       ///< by LinkPairIndex
  std::vector<std::uint32_t> closest;  ///< by LinkPairIndex: index into measured, or kNone
  std::vector<std::uint32_t> passed;   ///< by LinkPairIndex: the first in `passed`, or kNone
  /// By LinkPairIndex: index into measured of a Quality::estimate, kNone if there is none.
  std::vector<std::uint32_t> estimated;
  /// By LinkPairIndex: index into measured of what touches first, kNone if nothing does within
  /// the horizon.
  std::vector<std::uint32_t> soonest;
  /// Against the verdict last reported, in order of link pair. A clear pair that becomes
  /// unknown is no change of its own (the links that are unknown say it once for all their
  /// pairs); a pair that was near or touching and becomes unknown is one.
  std::vector<VerdictChange> changes;
  std::vector<std::uint32_t> island_of_link;  ///< by LinkId: 1, 2, ... in contact, 0 for the rest
  std::uint32_t island_count{0};
  std::vector<std::uint32_t> island_forest;  ///< by LinkId: scratch of the grouping
  std::uint32_t closest_of_all{kNone};       ///< index into measured
  /// [s] Of all pairs, the least; infinity if nothing meets within the horizon, unknown if nothing
  /// is known to and a pair is not known.
  double time_to_contact{kUnknown};
  Verdict overall{Verdict::unknown};
};

struct CycleCounters {
  std::size_t pairs{0};              ///< pairs of bodies in the table
  std::size_t candidates{0};         ///< of these, their bounds met
  std::size_t culled_by_cache{0};    ///< of these, too far apart by what was measured before
  std::size_t culled_by_spheres{0};  ///< of the rest, too far apart by their bounding spheres
  std::size_t culled_by_boxes{0};    ///< of the rest, oriented boxes parted: combination only
  std::size_t measured{0};           ///< the rest; without what the search for the closest looks at
  std::size_t refined{0};            ///< pairs of elements that were measured to the end
  std::size_t left{0};               ///< pairs of elements for which the budget did not suffice
  std::size_t refine_work{0};        ///< spent of the budget
  std::size_t swept{0};          ///< pairs near enough for their speed to have met since the last
                                 ///< cycle, which were followed on their way
  std::size_t swept_left{0};     ///< pairs of elements for which the budget did not suffice
  std::size_t unknown_pairs{0};  ///< pairs of bodies with an unknown link, or across two parts
  std::size_t unknown_links{0};  ///< links with geometry whose pose is unknown
};

/// Where the links were.
struct LastPoses {
  std::int64_t stamp_ns{0};
  std::vector<Pose> world_from_link;
  std::vector<unsigned char> known;
  std::vector<PartId> part;
};

/// Whether a link was known, and in the same part as now. What it did since is not known otherwise.
inline bool hasStayed(const LastPoses& last, const BodyPoses& now, std::size_t link) noexcept {
  return last.known[link] != 0 && now.link_known[link] != 0 && last.part[link] == now.part[link];
}

/// How far a body has come.
struct BodyTravel {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< of the body in the last cycle
  double all{0.0};      ///< [m] no point of the body has come farther since this was 0
  double of_link{0.0};  ///< [m] nor any of its link's bodies since the last cycle
  double ahead{0.0};  ///< [m] nor does it within the horizon or, continuous, did it since the last
                      ///< cycle; NaN: not known
};

/// What is still known of distances once measured.
struct DistanceCache {
  /// By PairId: [m] the distance when it was last measured, and what both ways were then; less
  /// what they are now a lower bound of the distance. -infinity where there is none.
  std::vector<double> distances;
  std::vector<BodyTravel> travels;  ///< by BodyId
  /// By ElementPairIndex: [m] the least distance of their bodies in the last cycle; infinity where
  /// none was measured.
  std::vector<double> nearest;
  std::vector<ElementPairIndex> measured_pairs;  ///< those with a `nearest`
};

/// The speed scale, and what it needs to be steady.
struct SpeedScale {
  double scale{1.0};                   ///< 0 stop .. 1 full speed
  std::int64_t stamp_ns{0};            ///< of the poses that it was found for
  std::vector<unsigned char> stopped;  ///< by LinkPairIndex: closed at stop_distance, and has not
                                       ///< parted since
};

/// What survives a cycle. Resetting it changes hysteresis, which verdicts count as changed, how
/// the speed scale grows, and of refinement the speed, the order and the estimates of depths;
/// contacts since the last cycle are then not looked for. Gaps change nothing but the time it
/// takes.
struct PairMemory {
  std::vector<Verdict> reported;       ///< by LinkPairIndex: the verdict last reported
  std::vector<Detail> contact_detail;  ///< by LinkPairIndex: the finest that showed the contact
                                       ///< that was reported
  SpeedScale speed;
  RefineStore refined;
  /// By ElementPairIndex: cycles in a row in which the budget was spent before its turn.
  std::vector<std::uint32_t> starved_cycles;
  DistanceCache distance_cache;
  LastPoses last;
};

}  // namespace collision_monitor
