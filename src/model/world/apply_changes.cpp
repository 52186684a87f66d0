// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "collision_monitor/model/world.h"
#include "model/nearest_name.h"
#include "model/place.h"
#include "model/world/check_object.h"

namespace collision_monitor {
namespace {

using Names = std::unordered_set<std::string>;

/// A longer list helps nobody, and a million faults would fill the memory.
constexpr std::size_t kMostFaults = 100;

/// Makes changes one by one in a copy of the world. Goes on after faults, to find the others.
class ChangeMaker {
 public:
  ChangeMaker(const World& world, const KnownPlaces& places, SetupReport& report)
      : world_(world),
        places_(places),
        links_(places.links.begin(), places.links.end()),
        frames_(places.link_frames.begin(), places.link_frames.end()),
        report_(report),
        most_errors_(report.errors.size() + kMostFaults) {}

  void make(const ObjectChange& change, std::size_t number) {
    change_ = "change " + std::to_string(number) + " (" + nameOf(change.kind) + ")";
    if (change.kind == ChangeKind::clear || change.kind == ChangeKind::replace_all) {
      world_.objects.clear();
    }
    if (change.objects.empty() == (change.kind != ChangeKind::clear)) {
      checkCount(change);
    }
    for (WorldObject object : change.objects) {
      if (isFull()) {
        return;
      }
      if (!object.frame.empty() && object.frame.front() == '/') {
        object.frame.erase(0, 1);  // "/map" and "map" mean the same, as in tf
      }
      where_ = (object.where.empty() ? change_ : object.where) + ", object " + quoted(object.name);
      makeOne(change, object);
    }
  }

  /// Whether no more faults are wanted.
  bool isFull() const { return report_.errors.size() >= most_errors_; }
  World take() { return std::move(world_); }

 private:
  void refuse(const std::string& found, const std::string& accepted) {
    report_.errors.push_back({where_, found, accepted});
  }

  void checkCount(const ObjectChange& change) {
    if (change.kind == ChangeKind::replace_all) {
      return;  // in place of all come none
    }
    where_ = change_;
    if (change.kind == ChangeKind::clear) {
      refuse("a list of objects", "an empty list, for all objects; remove takes names");
    } else {
      refuse("no objects", "at least one");
    }
  }

  void makeOne(const ObjectChange& change, const WorldObject& object) {
    switch (change.kind) {
      case ChangeKind::add:
      case ChangeKind::replace_all:
        return add(object);
      case ChangeKind::move:
        return move(object);
      case ChangeKind::remove:
        if (find(object.name) != nullptr) {
          world_.objects.erase(object.name);
        }
        return;
      case ChangeKind::attach:
        return attach(object, change.has_poses);
      case ChangeKind::detach:
        return detach(object);
      case ChangeKind::clear:
        return;  // reported already
    }
  }

  void add(WorldObject object) {
    checkName(object.name);
    checkObject(object, where_, report_);
    if (object.is_attached) {
      checkLink(object.frame, "link");
    } else if (object.frame.empty()) {
      object.frame = places_.world_frame;
    } else {
      checkFrame(object.frame);
    }
    checkTouchLinks(object);
    if (world_.objects.size() >= kMostObjects && world_.objects.count(object.name) == 0) {
      if (!is_crowded_) {
        refuse("more than " + std::to_string(kMostObjects) + " objects",
               "at most " + std::to_string(kMostObjects));
      }
      is_crowded_ = true;
      return;
    }
    put(std::move(object));
  }

  void checkName(const std::string& name) {
    if (name.empty()) {
      refuse("an object without name", "a name that no other object and no link has");
    } else if (std::any_of(name.begin(), name.end(),
                           [](unsigned char one) { return one < 0x20 || one == 0x7f; })) {
      refuse("a name with control characters", "names without");
    } else if (world_.objects.count(name) != 0) {
      refuse("this name twice", "names that no other object has; move and remove change objects");
    } else if (places_.waiting.count(name) != 0) {
      refuse("the name of an object that waits for a robot", "other names; remove ends its wait");
    } else if (links_.count(name) != 0 || frames_.count(name) != 0) {
      refuse("the name of a link", "a name that no link has");
    } else if (name == places_.world_frame) {
      refuse("the name of the world's frame", "another name");
    }
  }

  bool checkLink(const std::string& link, const std::string& what) {
    if (links_.count(link) != 0) {
      return true;
    }
    refuse(what + " " + quoted(link) + ", which is unknown" + suggestion(link, places_.links),
           "a link of the robots, by its name in messages");
    return false;
  }

  bool checkFrame(const std::string& frame) {
    if (frame == places_.world_frame || frames_.count(frame) != 0 || !places_.has_frame ||
        places_.has_frame(frame)) {
      return true;
    }
    refuse("frame " + quoted(frame) + ", which is unknown" + suggestion(frame, places_.link_frames),
           places_.other_frames.empty()
               ? "a frame that tf knows, a link's frame or the world frame " +
                     quoted(places_.world_frame)
               : "a link's frame, or " + places_.other_frames);
    return false;
  }

  void checkTouchLinks(const WorldObject& object) {
    for (const std::string& link : object.touch_links) {
      if (!places_.mayCome(link)) {
        checkLink(link, "touch link");
      }
    }
  }

  const WorldObject* find(const std::string& name) {
    const auto place = world_.objects.find(name);
    if (place != world_.objects.end()) {
      return place->second.get();
    }
    if (places_.waiting.count(name) != 0) {
      refuse("an object that waits for a robot", "one that is watched; remove ends the wait");
      return nullptr;
    }
    std::vector<std::string> names;
    for (const auto& [known, object] : world_.objects) {
      names.push_back(known);
    }
    refuse("no object of this name" + suggestion(name, names),
           names.empty() ? "there are no objects" : "one of " + someOf(names));
    return nullptr;
  }

  void put(WorldObject object) {
    std::string name = object.name;
    world_.objects.insert_or_assign(std::move(name),
                                    std::make_shared<const WorldObject>(std::move(object)));
  }

  void move(const WorldObject& wanted) {
    const WorldObject* found = find(wanted.name);
    checkPlacing(wanted.frame_from_object, where_, report_);
    if (found == nullptr) {
      return;
    }
    WorldObject object = *found;
    if (object.is_attached && !wanted.frame.empty() && wanted.frame != object.frame) {
      refuse("frame " + quoted(wanted.frame) + " for an object attached to link " +
                 quoted(object.frame),
             "no frame, for a pose in that link; detach sets the object free");
      return;
    }
    if (!object.is_attached && !wanted.frame.empty() && checkFrame(wanted.frame)) {
      object.frame = wanted.frame;
    }
    object.frame_from_object = wanted.frame_from_object;
    put(std::move(object));
  }

  void attach(const WorldObject& wanted, bool has_pose) {
    const WorldObject* found = find(wanted.name);
    const bool has_link = checkLink(wanted.frame, "link");
    WorldObject as_attached;
    as_attached.is_attached = true;
    as_attached.touch_links = wanted.touch_links;
    checkTouchLinks(as_attached);
    if (has_pose) {
      checkPlacing(wanted.frame_from_object, where_, report_);
    }
    if (found == nullptr || !has_link) {
      return;
    }
    WorldObject object = *found;
    if (has_pose) {
      object.frame_from_object = wanted.frame_from_object;
    } else if (!carryTo(wanted.frame, object)) {
      return;
    }
    object.frame = wanted.frame;
    object.is_attached = true;
    object.touch_links = wanted.touch_links;
    put(std::move(object));
  }

  void detach(const WorldObject& wanted) {
    const WorldObject* found = find(wanted.name);
    const std::string& frame = wanted.frame.empty() ? places_.world_frame : wanted.frame;
    const bool has_frame = checkFrame(frame);
    if (found == nullptr || !has_frame) {
      return;
    }
    WorldObject object = *found;
    if (!object.is_attached) {
      refuse("an object that is not attached", "an attached object; move places others");
    } else if (carryTo(frame, object)) {
      object.frame = frame;
      object.is_attached = false;
      object.touch_links.clear();
      put(std::move(object));
    }
  }

  /// Sets the pose of the object in another frame, where it stands.
  bool carryTo(const std::string& frame, WorldObject& object) {
    if (frame == object.frame) {
      return true;
    }
    const std::optional<Pose> pose =
        places_.find_pose ? places_.find_pose(frame, object.frame) : std::nullopt;
    if (!pose) {
      refuse("the pose of " + quoted(object.frame) + " in " + quoted(frame) + " is not known now",
             "frames that tf joins with fresh data, or attach with a pose");
      return false;
    }
    object.frame_from_object = *pose * object.frame_from_object;
    return true;
  }

  World world_;
  const KnownPlaces& places_;
  Names links_;
  Names frames_;
  SetupReport& report_;
  std::size_t most_errors_;
  std::string change_;  ///< "change 3 (add)"
  std::string where_;   ///< of the object at hand
  bool is_crowded_{false};
};

}  // namespace

const char* nameOf(ChangeKind kind) noexcept {
  constexpr const char* kNames[] = {"add",         "move",   "remove", "clear",
                                    "replace_all", "attach", "detach"};
  return kNames[static_cast<std::size_t>(kind)];
}

World applyChanges(const World& world, const std::vector<ObjectChange>& changes,
                   const KnownPlaces& places, SetupReport& report) {
  const std::size_t before = report.errors.size();
  ChangeMaker maker(world, places, report);
  for (std::size_t i = 0; i < changes.size() && !maker.isFull(); ++i) {
    maker.make(changes[i], i + 1);
  }
  if (maker.isFull()) {
    report.errors.push_back(
        {"changes", "more faults than are listed here", "changes without a fault"});
  }
  return report.errors.size() == before ? maker.take() : world;
}

}  // namespace collision_monitor
