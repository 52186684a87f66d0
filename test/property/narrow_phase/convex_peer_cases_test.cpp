// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "support/convex_measure.h"
#include "support/convex_reference.h"

// Cases of other libraries' test suites in which a cylinder, a convex set of points, a triangle or
// a half space takes part. Where an expectation and this package differ, the slow reference
// decides; such cases are printed and named in docs/accuracy.md.
namespace collision_monitor::test {
namespace {

using Json = nlohmann::json;

struct PosedGeometry {
  ConvexGeometry geometry;
  Pose world_from_body;
};

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

Eigen::Matrix3d rotationOntoZ(const Eigen::Vector3d& z) {
  Eigen::Matrix3d rotation;
  const Eigen::Vector3d x = z.unitOrthogonal();
  rotation << x, z.cross(x), z;
  return rotation;
}

PosedGeometry segmentOf(const Json& json) {
  const Eigen::Vector3d p = vectorOf(json.at("p"));
  const Eigen::Vector3d q = vectorOf(json.at("q"));
  const double length = (q - p).norm();
  Pose pose{Eigen::Matrix3d::Identity(), 0.5 * (p + q)};
  if (length > 0.0) {
    pose.rotation = rotationOntoZ((q - p) / length);
  }
  return {Capsule{0.5 * length, json.at("radius")}, pose};
}

PosedGeometry halfSpaceOf(const Json& json) {
  const Eigen::Vector3d normal = vectorOf(json.at("n"));
  const Pose plane{rotationOntoZ(normal.normalized()),
                   json.at("d").get<double>() / normal.squaredNorm() * normal};
  return {HalfSpace{}, poseOf(json.at("pose")) * plane};
}

std::optional<PosedGeometry> geometryOf(const Json& json) {
  const std::string type = json.at("type");
  if (type == "segment") {
    return segmentOf(json);
  }
  if (type == "halfspace") {
    return halfSpaceOf(json);
  }
  const Pose pose = poseOf(json.at("pose"));
  if (type == "sphere") {
    return PosedGeometry{Sphere{json.at("radius").get<double>()}, pose};
  }
  if (type == "capsule") {
    return PosedGeometry{Capsule{0.5 * json.at("length").get<double>(), json.at("radius")}, pose};
  }
  if (type == "box") {
    return PosedGeometry{Box{0.5 * vectorOf(json.at("size"))}, pose};
  }
  if (type == "cylinder") {
    return PosedGeometry{Cylinder{0.5 * json.at("length").get<double>(), json.at("radius")}, pose};
  }
  if (type == "convex" || type == "points" || type == "triangle") {
    std::vector<Eigen::Vector3d> points;
    for (const Json& vertex : json.at("vertices")) {
      points.push_back(vectorOf(vertex));
    }
    return PosedGeometry{ConvexHull(points), pose};
  }
  return std::nullopt;
}

bool isOfFamily(const ConvexGeometry& geometry) {
  return geometry.index() <= 3;  // sphere, capsule, box, rounded box: measured elsewhere
}

// What the peer asserts and we do not fulfil; empty when all is well.
std::string difference(const Json& expect, double distance) {
  const double slack = expect.value("tol", 0.0) + 1e-7 * (1.0 + std::abs(distance));
  if (expect.contains("distance") && expect["distance"].is_number() &&
      std::abs(distance - expect["distance"].get<double>()) > slack) {
    return "expected distance " + std::to_string(expect["distance"].get<double>());
  }
  if (expect.contains("unsigned_distance") &&
      std::abs(std::max(distance, 0.0) - expect["unsigned_distance"].get<double>()) > slack) {
    return "expected unsigned distance";
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
  int bounds{0};
  double worst_error{0.0};  // against the reference, relative to the lengths
};

void check(const Json& entry, const PosedGeometry& a, const PosedGeometry& b, Tally& tally) {
  const std::string id = entry.at("id");
  SCOPED_TRACE(id);
  const PosedConvexPair pair{&a.geometry, a.world_from_body, &b.geometry, b.world_from_body};
  const ConvexDistance found =
      measureCold(a.geometry, a.world_from_body, b.geometry, b.world_from_body);
  ASSERT_NE(found.quality, DistanceQuality::unknown);
  const double distance = found.measured.distance;
  const double scale =
      std::max(1.0, extentOf(a.geometry) + extentOf(b.geometry) +
                        (a.world_from_body.translation - b.world_from_body.translation).norm());
  ++tally.cases;
  tally.bounds += found.quality == DistanceQuality::exact ? 0 : 1;
  const ConvexCertificate proof = certify(pair, found.measured);
  EXPECT_NEAR(distance, proof.gap_along_normal, 1e-9 * scale);
  long double truth = static_cast<long double>(distance);
  if (convexReference(pair, truth)) {
    const double error = std::abs(distance - static_cast<double>(truth)) / scale;
    tally.worst_error = std::max(tally.worst_error, error);
    EXPECT_LE(error, 1e-6) << describe(pair);
  }
  const std::string differs = difference(entry.at("expect"), distance);
  if (!differs.empty()) {
    ++tally.differences;
    std::printf("| %s | %s | %.9g | %.9g |\n", id.c_str(), differs.c_str(), distance,
                static_cast<double>(truth));
  }
}

TEST(ConvexPeerCases, everyConvexPair_isDecidedByTheReference) {
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
      const auto a = geometryOf(entry.at("a"));
      const auto b = geometryOf(entry.at("b"));
      if (a && b && !(isOfFamily(a->geometry) && isOfFamily(b->geometry))) {
        check(entry, *a, *b, tally);
      }
    }
  }
  std::printf("%d cases, worst error %.1e of the lengths, %d bounds, %d expectations not met\n",
              tally.cases, tally.worst_error, tally.bounds, tally.differences);
  EXPECT_GT(tally.cases, 0);
  EXPECT_EQ(tally.differences, 0);
}

}  // namespace
}  // namespace collision_monitor::test
