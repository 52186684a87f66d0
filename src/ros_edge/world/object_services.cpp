// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/object_services.h"

#include <ros/console.h>

#include <algorithm>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "ros_edge/parameters/resource_loader.h"
#include "ros_edge/world/convert_objects.h"
#include "ros_edge/world/held_back.h"
#include "ros_edge/world/world_places.h"

namespace collision_monitor {
namespace {

/// [s] The longest wait for frames that tf was not asked for before.
constexpr double kPatience = 1.0;

std::string countText(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " object" : " objects");
}

bool isIdle(const PairRule& rule, const CycleSetup& setup) {
  return std::none_of(setup.link_pairs.begin(), setup.link_pairs.end(),
                      [&](const LinkPair& pair) { return selects(rule, pair.a, pair.b); });
}

/// "; rules.yaml line 3, rule 1 selects no pair any more", of each rule that lost its last pair.
/// @pre both have the same rules
std::string idleRulesText(const CycleSetup& before, const CycleSetup& now) {
  std::string text;
  for (std::size_t i = 0; i < now.pair_rules.size(); ++i) {
    if (isIdle(now.pair_rules[i], now) && !isIdle(before.pair_rules[i], before)) {
      text += "; " + now.pair_rules[i].where + " selects no pair any more";
    }
  }
  return text;
}

}  // namespace

ObjectServices::ObjectServices(const ros::NodeHandle& private_node, const Inputs& inputs,
                               ObjectHooks hooks, ChangeLocks& locks, ServiceQueue& quick,
                               ServiceQueue& changes)
    : private_node_(private_node), inputs_(inputs), hooks_(std::move(hooks)), locks_(locks) {
  apply_objects_ = changes.serve(private_node_, "apply_objects", &ObjectServices::apply, this);
  get_objects_ = quick.serve(private_node_, "get_objects", &ObjectServices::list, this);
}

bool ObjectServices::apply(ApplyObjects::Request& request, ApplyObjects::Response& response) {
  response.success = 0;
  try {
    const Interruptible interruptible(hooks_.goes_on);
    SetupReport report;
    const std::vector<ObjectChange> changes = read(request.changes, report);
    // Only now, so that files that load slowly keep no other change waiting.
    const auto lock = locks_.beginChange();
    if (!lock) {
      response.message = kOtherChange;
      return true;
    }
    const std::shared_ptr<const MonitorSetup> before = hooks_.current_setup();
    std::vector<WorldObject> held_back;
    const World start = worldBefore(changes, *before, held_back);
    KnownPlaces places = placesNow(*before, inputs_, kPatience);
    for (const WorldObject& object : held_back) {
      places.waiting.insert(object.name);
    }
    const World world = applyChanges(start, changes, places, report);
    throwIfErrors(report);
    const std::lock_guard<std::mutex> swap(locks_.swap);  // only now: waiting for frames takes long
    const std::shared_ptr<const MonitorSetup> former = hooks_.current_setup();
    hooks_.replace_world(changeWorld(*former, world, std::move(held_back)));
    response.message = "watching " + countText(world.objects.size()) +
                       idleRulesText(former->setup, hooks_.current_setup()->setup);
    response.success = 1;
  } catch (const std::exception& fault) {
    response.message = "nothing was changed: " + failureText(fault);
  } catch (const Interrupted&) {
    response.message = "nothing was changed: the monitor ends";
  }
  return true;
}

std::vector<ObjectChange> ObjectServices::read(const std::vector<SceneChange>& messages,
                                               SetupReport& report) const {
  const std::shared_ptr<const MonitorSetup> current = hooks_.current_setup();
  const ResourceLoader load_resource = makeResourceLoader(current->parameters.loading);
  return fromMessages(messages, {load_resource, current->parameters.setup.meshes}, report);
}

bool ObjectServices::list(GetObjects::Request& /*request*/, GetObjects::Response& response) {
  response.objects = listOf(*hooks_.current_setup());
  return true;
}

}  // namespace collision_monitor
