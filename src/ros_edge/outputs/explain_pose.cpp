// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "model/place.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/poses/pose_reader.h"
#include "ros_edge/to_seconds.h"

namespace collision_monitor {
namespace {

std::string inSeconds(double value) { return fixedText(value, 2) + " s"; }

/// [s] No delay explains this age; most likely there are two clocks.
constexpr double kSuspiciousAge = 60.0;

/// @param what the data: "transform to 'hand'", "state of joint 'elbow'"
std::string explainAge(double age, double max_age, const std::string& what) {
  if (std::abs(age) <= max_age) {
    return what + " resumed after a gap and is not complete yet";
  }
  if (age < 0.0) {
    return "the newest " + what + " is " + inSeconds(-age) +
           " in the future; the clocks of two machines differ, or use_sim_time is set for one node "
           "only";
  }
  const bool is_suspicious = age > kSuspiciousAge;
  return "no " + what + " for " + inSeconds(age) +
         (is_suspicious ? "; if this is a recording, is use_sim_time set?" : "");
}

std::string countText(std::uint64_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

/// [s] Time from then to the last read.
double PoseReader::since(std::int64_t then_ns) const { return toSeconds(now_ns_ - then_ns); }

/// Whether data of that time may still come from a live source.
bool PoseReader::isOfNow(std::int64_t then_ns) const {
  constexpr double kSlow = 1.0;  // [s] few sources send less often
  return since(then_ns) <= std::max(max_age_, kSlow);
}

/// Explains missing data by older data that were refused.
std::string PoseReader::explainBefore(const Refusal& refusal) const {
  return refusal.ahead_ns == 0 ? ""
                               : "; what came last, " + inSeconds(since(refusal.at_ns)) +
                                     " ago, was refused: it was " +
                                     inSeconds(toSeconds(refusal.ahead_ns)) + " in the future";
}

/// For users who send data without a stamp, or by another clock, and wonder why none arrive.
std::string PoseReader::refused(const Refusals& refusals, const char* what,
                                const char* reason) const {
  if (refusals.count == 0) {
    return "";
  }
  return std::string("; refused ") + reason + ": " + countText(refusals.count, what) +
         (isOfNow(refusals.last_ns) ? ""
                                    : ", the last " + inSeconds(since(refusals.last_ns)) + " ago");
}

/// Explains who sent contradicting data for one time.
std::string PoseReader::explainContradiction(const Edge& edge) const {
  if (edge.joint != nullptr) {
    const Joint& joint = edge.joint->mimic ? model_.joint(edge.joint->mimic->source) : *edge.joint;
    const Contradiction& last = joints_->newest(joint.first_variable).contradiction;
    return whoSends(joints_->publisher(last.first), joints_->publisher(last.second)) +
           " different positions of joint '" + joint.name + "' with one stamp";
  }
  for (const std::size_t frame : edge.moving_path) {
    const FrameRecord& record = records_[frame];
    if (isRecent(record.contradiction, record.newest_ns, max_age_)) {
      return whoSends(store_.publisher(record.contradiction.first),
                      store_.publisher(record.contradiction.second)) +
             " different transforms to '" + record.name + "' with one stamp";
    }
  }
  return "its sources contradicted each other";
}

/// For a link that a joint places or should place.
std::string PoseReader::explainJoint(const Edge& edge) const {
  // A mimic joint depends on its source.
  const Joint& joint = edge.joint->mimic ? model_.joint(edge.joint->mimic->source) : *edge.joint;
  const std::string what = "state of joint '" + joint.name + "'";
  const Refusal refusal = joints_->refusedAhead(joint.first_variable);
  if (refusal.ahead_ns > 0 && isOfNow(refusal.at_ns)) {
    return explainAge(-toSeconds(refusal.ahead_ns), max_age_, what);
  }
  const std::string why = explainBefore(refusal) + refused(joints_->refusedWithoutStamp(),
                                                           "JointState", "for want of a stamp");
  switch (edge.status) {
    case LinkStatus::stale:
      return explainAge(edge.age, max_age_, what) + why;
    case LinkStatus::not_finite:
      return "the position of joint '" + joint.name +
             "' is missing in its message, not finite or beyond 1e9";
    case LinkStatus::contradicted:
      return explainContradiction(edge);
    default:
      return "no " + what + " yet" + why;
  }
}

/// For a link that tf places or should place. All links below a loop get the same text.
std::string PoseReader::explainMissing(const Edge& edge) const {
  for (const std::string& frame : {edge.child_frame, edge.parent_frame}) {
    if (!edge.is_connected && chainAbove(frame).empty()) {
      std::string text = "transforms lead in a loop: ";
      const std::vector<std::string> loop = loopAbove(frame);
      for (const std::string& step : loop) {
        text += legible(step) + " -> ";
      }
      return text + legible(loop.front()) +
             ", each to its parent; send one of these frames with another parent, or stop sending "
             "it";
    }
  }
  return std::string(edge.is_connected ? "no usable" : "no") + " transform from '" +
         edge.parent_frame + "' to '" + edge.child_frame + "' yet" +
         refused(store_.refusedWithoutStamp(), "transform", "for want of a stamp") +
         refused(store_.refusedAhead(), "transform", "as too far in the future");
}

/// The latest data for this link that were refused for being too far ahead of now.
Refusal PoseReader::refusedAhead(const Edge& edge) const {
  Refusal latest;
  const auto look = [&](std::size_t record) {
    const Refusal& refusal = records_[record].refusal;
    if (refusal.ahead_ns > 0 && refusal.at_ns >= latest.at_ns) {
      latest = refusal;
    }
  };
  std::for_each(edge.path.begin(), edge.path.end(), look);
  for (const std::string& frame : {edge.child_frame, edge.parent_frame}) {
    for (const std::string& above :
         edge.is_connected ? std::vector<std::string>() : chainAbove(frame)) {
      const auto place = places_.find(above);
      if (place != places_.end()) {
        look(place->second);
      }
    }
  }
  return latest;
}

std::string PoseReader::explain(LinkId link) const {
  // The fault above the top of this part. Of several faults in a chain, the topmost is the cause.
  // An unknown root does not matter to links below another fault.
  const Edge* cause = nullptr;
  for (std::size_t i = index(link);;) {
    const auto& joint = model_.links[i].parent_joint;
    const bool is_fault = edges_[i].status != LinkStatus::known;
    if (cause != nullptr && (!is_fault || !joint)) {
      break;
    }
    cause = is_fault ? &edges_[i] : cause;
    if (!joint) {
      break;
    }
    i = index(model_.joint(*joint).parent);
  }
  if (cause == nullptr) {
    return "its pose is known";
  }
  const bool is_own = cause == &edges_[index(link)];
  const std::string to = is_own ? "" : " to '" + cause->child_frame + "'";
  if (cause->joint != nullptr) {
    return explainJoint(*cause);
  }
  const Refusal refusal = refusedAhead(*cause);
  if (refusal.ahead_ns > 0 && isOfNow(refusal.at_ns)) {
    return explainAge(-toSeconds(refusal.ahead_ns), max_age_, "transform" + to);
  }
  switch (cause->status) {
    case LinkStatus::stale:
      return explainAge(cause->age, max_age_, "transform" + to) + explainBefore(refusal);
    case LinkStatus::not_finite:
      return "the transform to '" + cause->child_frame +
             "' is not finite, no rotation or farther than 1e9 m";
    case LinkStatus::contradicted:
      return explainContradiction(*cause);
    default:
      return explainMissing(*cause);
  }
}

}  // namespace collision_monitor
