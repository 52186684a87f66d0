// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "collision_monitor/narrow_phase/distance.h"
#include "support/expect_distance.h"
#include "support/random_pairs.h"
#include "support/reference_distance.h"

// Cases of other libraries' test suites. Where an expectation and this package differ, the exact
// reference decides; such cases are printed.
namespace collision_monitor::test {
namespace {

using Json = nlohmann::json;

std::filesystem::path sharedData() {
  const char* given = std::getenv("COLLISION_MONITOR_SHARED_DATA");
  return given != nullptr ? std::filesystem::path(given)
                          : std::filesystem::path(COLLISION_MONITOR_SOURCE_DIR) / "../shared/data";
}

Eigen::Vector3d vectorOf(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

// Some issue threads give rotations to six digits; the nearest proper rotation is meant.
Pose poseOf(const Json& json) {
  Pose pose;
  for (Eigen::Index row = 0; row < 3; ++row) {
    pose.rotation.row(row) = vectorOf(json.at("R").at(static_cast<std::size_t>(row)));
  }
  if (!isRigid(pose, 1e-14)) {
    pose.rotation = Eigen::Quaterniond(pose.rotation).normalized().toRotationMatrix();
  }
  pose.translation = vectorOf(json.at("t"));
  return pose;
}

struct PosedShape {
  Shape shape;
  Pose world_from_shape;
};

PosedShape segmentOf(const Json& json) {
  const Eigen::Vector3d p = vectorOf(json.at("p"));
  const Eigen::Vector3d q = vectorOf(json.at("q"));
  const double length = (q - p).norm();
  Pose pose{Eigen::Matrix3d::Identity(), 0.5 * (p + q)};
  if (length > 0.0) {
    pose.rotation =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), q - p).toRotationMatrix();
  }
  return {Capsule{0.5 * length, json.at("radius").get<double>()}, pose};
}

// Nothing for a shape that this family does not have.
std::optional<PosedShape> shapeOf(const Json& json) {
  const std::string type = json.at("type");
  if (type == "segment") {
    return segmentOf(json);
  }
  if (type == "sphere") {
    return PosedShape{Sphere{json.at("radius").get<double>()}, poseOf(json.at("pose"))};
  }
  if (type == "capsule") {
    return PosedShape{Capsule{0.5 * json.at("length").get<double>(), json.at("radius")},
                      poseOf(json.at("pose"))};
  }
  if (type == "box") {
    return PosedShape{Box{0.5 * vectorOf(json.at("size"))}, poseOf(json.at("pose"))};
  }
  return std::nullopt;
}

double lengthsOf(const ShapePair& pair) {
  return coreHalfExtents(pair.a).norm() + radiusOf(pair.a) + coreHalfExtents(pair.b).norm() +
         radiusOf(pair.b) + (pair.world_from_a.translation - pair.world_from_b.translation).norm();
}

// What the peer asserts and we do not fulfil; empty when all is well.
std::string difference(const Json& expect, double distance) {
  const double slack = expect.value("tol", 0.0) + 1e-9 * (1.0 + std::abs(distance));
  if (expect.contains("distance") && expect["distance"].is_number()) {
    const double expected = expect["distance"];
    if (std::abs(distance - expected) > slack) {
      return "expected distance " + std::to_string(expected);
    }
  }
  if (expect.contains("unsigned_distance")) {
    const double expected = expect["unsigned_distance"];
    if (std::abs(std::max(distance, 0.0) - expected) > slack) {
      return "expected unsigned distance " + std::to_string(expected);
    }
  }
  const double beyond = distance - expect.value("margin", 0.0);
  if (expect.contains("collide") && std::abs(beyond) > slack &&
      expect["collide"].get<bool>() != (beyond < 0.0)) {
    return std::string("expected collide = ") + (expect["collide"].get<bool>() ? "true" : "false");
  }
  return "";
}

struct Tally {
  int cases{0};
  int differences{0};
  double worst_error{0.0};  // against the reference, relative to the lengths
};

void check(const Json& entry, const ShapePair& pair, Tally& tally) {
  const std::string id = entry.at("id");
  SCOPED_TRACE(id);
  const SignedDistance found =
      distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
  const double truth =
      referenceDistance(pair.a, pair.world_from_a, pair.b, pair.world_from_b).distance;
  const double scale = std::max(1.0, lengthsOf(pair));
  ++tally.cases;
  tally.worst_error = std::max(tally.worst_error, std::abs(found.distance - truth) / scale);
  EXPECT_NEAR(found.distance, truth, 1e-13 * scale);
  EXPECT_NEAR(found.normal_a_to_b.norm(), 1.0, kExact);
  const Eigen::Vector3d joined = found.point_on_b - found.point_on_a;
  EXPECT_LE((joined - found.distance * found.normal_a_to_b).norm(), 1e-13 * scale);
  const std::string differs = difference(entry.at("expect"), found.distance);
  if (!differs.empty()) {
    ++tally.differences;
    std::printf("%s: %s, found %.9g, reference %.9g\n", id.c_str(), differs.c_str(), found.distance,
                truth);
  }
}

TEST(PeerCases, everyPairOfOurShapes_isDecidedByTheReference) {
  const std::filesystem::path folder = sharedData() / "peer_cases";
  if (!std::filesystem::is_directory(folder)) {
    GTEST_SKIP() << "no peer cases at " << folder
                 << "; set COLLISION_MONITOR_SHARED_DATA to the folder that holds peer_cases";
  }
  Tally tally;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".json") {
      continue;
    }
    std::ifstream stream(file.path());
    for (const Json& entry : Json::parse(stream).value("cases", Json::array())) {
      const auto a = shapeOf(entry.at("a"));
      const auto b = shapeOf(entry.at("b"));
      if (a && b) {
        check(entry, {a->shape, a->world_from_shape, b->shape, b->world_from_shape}, tally);
      }
    }
  }
  std::printf("%d cases, worst error %.1e of the lengths, %d expectations not met\n", tally.cases,
              tally.worst_error, tally.differences);
  EXPECT_GT(tally.cases, 0);
  EXPECT_EQ(tally.differences, 0);
}

}  // namespace
}  // namespace collision_monitor::test
