// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/proofs/surrounding_mesh.h"

namespace collision_monitor::test {
namespace {

TriangleMesh meshOf(const Geometry& geometry) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    return *mesh;
  }
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return surroundingMesh(*box);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    return surroundingMesh(*cylinder);
  }
  return {};
}

std::vector<double> travelsOf(const JointPath& path, const PathPart& part) {
  std::vector<double> travels;
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    travels.push_back(travelOf(path, part, i));
  }
  return travels;
}

/// How far along a segment a distance lasts, from a given share: halved until it does.
double lastingShare(FclPath& all, LinkPairIndex pair, const PathPart& rest,
                    const std::vector<Pose>& world_from_link, double distance) {
  PathPart part = rest;
  all.levers.moveTo(world_from_link);
  while (boundMotion(all.chains[pair], travelsOf(all.path, part), all.levers) > distance) {
    part.to = 0.5 * (part.from + part.to);
  }
  return part.to;
}

}  // namespace

FclRobot::FclRobot(const RobotModel& model) : objects_(model.links.size()) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    for (const CollisionElement& element : model.links[i].collisions) {
      TriangleMesh mesh = meshOf(element.geometry);
      for (Eigen::Vector3d& vertex : mesh.vertices) {
        vertex = element.link_from_geometry * vertex;
      }
      if (!mesh.triangles.empty()) {
        objects_[i].emplace_back(toFcl(mesh));
      }
    }
  }
}

void FclRobot::place(LinkId link, const Pose& world_from_link) {
  for (fcl::CollisionObjectd& object : objects_[index(link)]) {
    object.setTransform(world_from_link.rotation, world_from_link.translation);
    object.computeAABB();
  }
}

bool FclRobot::overlaps(const CheckedLinkPair& pair) const {
  for (const fcl::CollisionObjectd& a : objects_[index(pair.a)]) {
    for (const fcl::CollisionObjectd& b : objects_[index(pair.b)]) {
      // As FCL's managers do: bounding boxes first.
      if (a.getAABB().overlap(b.getAABB()) && fclMeshOverlap(a, b)) {
        return true;
      }
    }
  }
  return false;
}

double FclRobot::distance(const CheckedLinkPair& pair) const {
  double least = std::numeric_limits<double>::infinity();
  for (const fcl::CollisionObjectd& a : objects_[index(pair.a)]) {
    for (const fcl::CollisionObjectd& b : objects_[index(pair.b)]) {
      if (a.getAABB().distance(b.getAABB()) < least) {
        least = std::min(least, fclMeshDistance(a, b));
      }
    }
  }
  return least;
}

FclPath::FclPath(const CycleSetup& cycle_setup, const JointPath& joint_path, const LinkPoses& start)
    : setup(cycle_setup),
      path(joint_path),
      poses(setup.model, path, start),
      robot(setup.model),
      levers(linkBalls(setup), setup.model, path) {
  for (const CheckedLinkPair& pair : setup.checked) {
    chains.push_back(chainBetween(setup.model, path, pair.a, pair.b));
  }
}

std::vector<std::uint64_t> countSamples(FclPath& all, double step) {
  std::vector<std::uint64_t> counts;
  std::vector<Pose> world_from_link;
  for (std::size_t segment = 0; segment + 1 < all.path.times.size(); ++segment) {
    all.poses.place(segment, 0.0, world_from_link);
    const std::vector<double> travels = travelsOf(all.path, {segment, 0.0, 1.0});
    double farthest = 0.0;
    all.levers.moveTo(world_from_link);
    for (const LinkChain& chain : all.chains) {
      farthest = std::max(farthest, boundMotion(chain, travels, all.levers));
    }
    counts.push_back(
        std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(farthest / step))));
  }
  return counts;
}

std::uint64_t sampleOverlaps(FclPath& all, const std::vector<std::uint64_t>& samples,
                             std::size_t part, const std::vector<double>& contact_times) {
  std::vector<Pose> world_from_link;
  std::uint64_t taken = 0;
  for (std::size_t segment = 0; segment < samples.size(); segment += part) {
    for (std::uint64_t i = 0; i < samples[segment]; ++i, ++taken) {
      const double share = static_cast<double>(i) / static_cast<double>(samples[segment]);
      const double time = timeAt(all.path, segment, share);
      all.poses.place(segment, share, world_from_link);
      for (std::size_t link = 0; link < world_from_link.size(); ++link) {
        all.robot.place(idAt<LinkId>(link), world_from_link[link]);
      }
      for (LinkPairIndex pair = 0; pair < contact_times.size(); ++pair) {
        if (time < contact_times[pair]) {
          all.robot.overlaps(all.setup.checked[pair]);
        }
      }
    }
  }
  return taken;
}

std::uint64_t followDistances(FclPath& all, double tolerance, std::size_t& contacts) {
  std::vector<Pose> world_from_link;
  std::uint64_t looks = 0;
  contacts = 0;
  for (LinkPairIndex pair = 0; pair < all.chains.size(); ++pair) {
    const CheckedLinkPair& links = all.setup.checked[pair];
    const std::uint64_t segments = all.path.times.size() - 1;
    PathPart rest;
    while (rest.segment < segments) {
      all.poses.place(rest.segment, rest.from, world_from_link);
      all.robot.place(links.a, world_from_link[index(links.a)]);
      all.robot.place(links.b, world_from_link[index(links.b)]);
      const double distance = all.robot.distance(links);
      ++looks;
      if (distance <= tolerance) {
        ++contacts;
        break;
      }
      rest.from = lastingShare(all, pair, rest, world_from_link, distance);
      if (rest.from >= 1.0) {
        rest = {rest.segment + 1, 0.0, 1.0};
      }
    }
  }
  return looks;
}

}  // namespace collision_monitor::test
