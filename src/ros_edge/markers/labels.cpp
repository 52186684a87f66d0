// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

constexpr double kLetterWidth = 0.55 * kTextHeight;
constexpr double kLineHeight = 1.3 * kTextHeight;
constexpr double kMostRise = 1.0;  ///< [m] above what is higher, as rooms are, a text is not seen
constexpr double kSlope = 0.6;     ///< of a view from 30 degrees above: what is nearer hides less

const PairDistance& closestOf(const Watch& watch, LinkPairIndex link_pair) {
  return watch.buffers.distances.pairs[watch.buffers.events.closest[link_pair]];
}

/// Less is more urgent.
std::tuple<int, double, double> urgencyOf(const Watch& watch, LinkPairIndex link_pair) {
  const PairEvents& events = watch.buffers.events;
  const PairDistance& closest = closestOf(watch, link_pair);
  const std::uint32_t soonest = events.soonest[link_pair];
  const bool has_time = events.verdicts[link_pair] == Verdict::warning && soonest != kNone;
  const double time = has_time ? watch.buffers.distances.pairs[soonest].time_to_contact
                               : std::numeric_limits<double>::infinity();
  return {-static_cast<int>(events.verdicts[link_pair]), time, closest.measured.distance};
}

/// A lower bound may be less than the distance, an estimate more.
std::string distanceText(const Snapshot::Label& label) {
  const char* relation = label.quality == Quality::lower_bound ? ">= "
                         : label.quality == Quality::estimate  ? "<= "
                                                               : "";
  return relation + std::string(label.distance < 0.0 ? "-" : "") + lengthText(label.distance);
}

}  // namespace

std::vector<LinkPairIndex> chooseLabelled(const Watch& watch, std::size_t most) {
  const PairEvents& events = watch.buffers.events;
  std::vector<LinkPairIndex> chosen;
  for (const LinkPairIndex i : events.active) {
    if (events.verdicts[i] != Verdict::clear && events.closest[i] != kNone) {
      chosen.push_back(i);
    }
  }
  const auto end = chosen.begin() + static_cast<std::ptrdiff_t>(std::min(most, chosen.size()));
  std::partial_sort(chosen.begin(), end, chosen.end(), [&](LinkPairIndex a, LinkPairIndex b) {
    return std::pair(urgencyOf(watch, a), a) < std::pair(urgencyOf(watch, b), b);
  });
  chosen.erase(end, chosen.end());
  if (events.closest_of_all != kNone && chosen.size() < most) {
    const PairId nearest = watch.buffers.distances.pairs[events.closest_of_all].pair;
    const LinkPairIndex link_pair = watch.setup().link_pair_of[index(nearest)];
    if (events.verdicts[link_pair] == Verdict::clear) {
      chosen.push_back(link_pair);
    }
  }
  return chosen;
}

std::string labelText(const CycleSetup& setup, const Snapshot::Label& label) {
  const CheckedLinkPair& links = setup.checked[label.link_pair];
  return distanceText(label) + "\n" + nameInText(setup.model, links.a) + " - " +
         nameInText(setup.model, links.b);
}

const LabelPlaces::Taken* LabelPlaces::inTheWayOf(const Taken& text) const {
  const auto found = std::find_if(taken_.begin(), taken_.end(), [&](const Taken& other) {
    const Eigen::Vector3d apart = text.place - other.place;
    const double beside = apart.head<2>().norm();
    // Texts face the viewer, who may stand on any side.
    return beside < 0.5 * (text.width + other.width) &&
           std::abs(apart.z()) < 0.5 * (text.height + other.height) + kSlope * beside;
  });
  return found == taken_.end() ? nullptr : &*found;
}

void LabelPlaces::raise(const std::vector<Aabb>& solids, double most, Taken& text) {
  const Eigen::Vector2d place = text.place.head<2>();
  for (const Aabb& box : solids) {
    const Eigen::Vector2d nearest = place.cwiseMax(box.min.head<2>()).cwiseMin(box.max.head<2>());
    const double beside = std::max(0.0, (nearest - place).norm() - 0.5 * text.width);
    const double least = box.max.z() - kSlope * beside + 0.5 * text.height;
    if (least > text.place.z() && least <= most) {
      text.place.z() = least;
    }
  }
}

Eigen::Vector3d LabelPlaces::take(const Eigen::Vector3d& wanted, const std::string& text,
                                  const std::vector<Aabb>& solids) {
  std::size_t longest = 0;
  std::size_t lines = 1;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    longest = std::max(longest, end - begin);
    begin = end + 1;
    ++lines;
  }
  longest = std::max(longest, text.size() - begin);
  Taken place{wanted, kLetterWidth * static_cast<double>(longest),
              kLineHeight * static_cast<double>(lines)};
  const double most = wanted.z() + kMostRise;
  raise(solids, most, place);
  if (const Taken* other = inTheWayOf(place)) {
    place.place.head<2>() = other->place.head<2>();
    raise(solids, most, place);
  }
  while (inTheWayOf(place) != nullptr) {
    place.place.z() += 0.25 * place.height;
  }
  taken_.push_back(place);
  return place.place;
}

}  // namespace collision_monitor
