// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase_peers.h"

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>
#include <fcl/geometry/shape/box.h>

#include <stdexcept>
#include <utility>

namespace collision_monitor::bench {
namespace {

using FclManager = fcl::BroadPhaseCollisionManager<double>;
using FclObject = fcl::CollisionObject<double>;

bool countPair(FclObject*, FclObject*, void* count) {
  ++*static_cast<std::size_t*>(count);
  return false;
}

/// @param registers_anew FCL's fastest method if everything has moved.
class FclContender : public Contender {
 public:
  FclContender(std::unique_ptr<FclManager> manager, const BoxScene& scene, bool registers_anew)
      : manager_(std::move(manager)), registers_anew_(registers_anew) {
    for (const Aabb& box : scene.bounds().boxes) {
      const Eigen::Vector3d edges = box.max - box.min;
      objects_.push_back(std::make_unique<FclObject>(std::make_shared<fcl::Box<double>>(edges)));
      pointers_.push_back(objects_.back().get());
    }
    moveTo(scene.bounds());
    manager_->registerObjects(pointers_);
    manager_->setup();
  }

  void prepare(const BodyBounds& bounds) override { moveTo(bounds); }

  std::size_t run() override {
    if (registers_anew_) {
      manager_->clear();
      manager_->registerObjects(pointers_);
      manager_->setup();
    } else {
      manager_->update();
    }
    std::size_t count = 0;
    manager_->collide(&count, countPair);
    return count;
  }

 private:
  void moveTo(const BodyBounds& bounds) {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      objects_[i]->setTranslation(0.5 * (bounds.boxes[i].min + bounds.boxes[i].max));
      objects_[i]->computeAABB();
    }
  }

  std::unique_ptr<FclManager> manager_;
  bool registers_anew_;
  std::vector<std::unique_ptr<FclObject>> objects_;
  std::vector<FclObject*> pointers_;
};

btVector3 toBullet(const Eigen::Vector3d& point) {
  return {static_cast<btScalar>(point.x()), static_cast<btScalar>(point.y()),
          static_cast<btScalar>(point.z())};
}

class BulletContender : public Contender {
 public:
  BulletContender(std::unique_ptr<btBroadphaseInterface> broad_phase, const BoxScene& scene)
      : broad_phase_(std::move(broad_phase)) {
    prepare(scene.bounds());
    for (const auto& [min, max] : boxes_) {
      proxies_.push_back(broad_phase_->createProxy(min, max, 0, this, 1, -1, nullptr));
    }
  }

  ~BulletContender() override {
    for (btBroadphaseProxy* proxy : proxies_) {
      broad_phase_->destroyProxy(proxy, nullptr);
    }
  }

  void prepare(const BodyBounds& bounds) override {
    boxes_.clear();
    for (const Aabb& box : bounds.boxes) {
      boxes_.emplace_back(toBullet(box.min), toBullet(box.max));
    }
  }

  std::size_t run() override {
    for (std::size_t i = 0; i < proxies_.size(); ++i) {
      broad_phase_->setAabb(proxies_[i], boxes_[i].first, boxes_[i].second, nullptr);
    }
    broad_phase_->calculateOverlappingPairs(nullptr);
    return static_cast<std::size_t>(
        broad_phase_->getOverlappingPairCache()->getNumOverlappingPairs());
  }

 private:
  std::unique_ptr<btBroadphaseInterface> broad_phase_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::vector<std::pair<btVector3, btVector3>> boxes_;
};

/// Null if FCL has no manager of that name. @param far no box is farther out on any axis [m].
std::unique_ptr<FclManager> makeManager(const std::string& name, double far) {
  if (name == "fcl_tree" || name == "fcl_tree_anew") {
    return std::make_unique<fcl::DynamicAABBTreeCollisionManager<double>>();
  }
  if (name == "fcl_tree_array") {
    return std::make_unique<fcl::DynamicAABBTreeCollisionManager_Array<double>>();
  }
  if (name == "fcl_sap") {
    return std::make_unique<fcl::SaPCollisionManager<double>>();
  }
  if (name == "fcl_ssap") {
    return std::make_unique<fcl::SSaPCollisionManager<double>>();
  }
  if (name == "fcl_interval") {
    return std::make_unique<fcl::IntervalTreeCollisionManager<double>>();
  }
  if (name == "fcl_spatial_hash") {
    const auto corner = Eigen::Vector3d::Constant(far).eval();
    return std::make_unique<fcl::SpatialHashingCollisionManager<double>>(2.0, -corner, corner);
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> peerNames() {
  return {"fcl_tree",         "fcl_tree_array", "fcl_sap",     "fcl_ssap",    "fcl_interval",
          "fcl_spatial_hash", "fcl_tree_anew",  "bullet_dbvt", "bullet_sweep"};
}

std::unique_ptr<Contender> makePeer(const std::string& name, const BoxScene& scene) {
  const double far = 0.5 * scene.side() + 40.0;
  if (std::unique_ptr<FclManager> manager = makeManager(name, far)) {
    return std::make_unique<FclContender>(std::move(manager), scene, name == "fcl_tree_anew");
  }
  const auto corner = toBullet(Eigen::Vector3d::Constant(far));
  if (name == "bullet_dbvt") {
    return std::make_unique<BulletContender>(std::make_unique<btDbvtBroadphase>(), scene);
  }
  if (name == "bullet_sweep") {
    const auto room = static_cast<unsigned>(scene.bounds().boxes.size() + 2);
    return std::make_unique<BulletContender>(
        std::make_unique<bt32BitAxisSweep3>(-corner, corner, room), scene);
  }
  throw std::invalid_argument("no peer '" + name + "'");
}

}  // namespace collision_monitor::bench
