// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/peer_cases.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "support/robots/file_loader.h"

namespace collision_monitor::test {
namespace {

using Json = nlohmann::json;

Eigen::Vector3d vectorOf(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

// Some issue threads give rotations to six digits: takes the nearest proper rotation.
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

PeerGeometry segmentOf(const Json& json) {
  const Eigen::Vector3d p = vectorOf(json.at("p"));
  const Eigen::Vector3d q = vectorOf(json.at("q"));
  const double length = (q - p).norm();
  Pose pose{Eigen::Matrix3d::Identity(), 0.5 * (p + q)};
  if (length > 0.0) {
    pose.rotation = rotationOntoZ((q - p) / length);
  }
  return {Capsule{0.5 * length, json.at("radius")}, pose};
}

PeerGeometry halfSpaceOf(const Json& json) {
  const Eigen::Vector3d normal = vectorOf(json.at("n"));
  const Pose plane{rotationOntoZ(normal.normalized()),
                   json.at("d").get<double>() / normal.squaredNorm() * normal};
  return {HalfSpace{}, poseOf(json.at("pose")) * plane};
}

ConvexHull hullOf(const Json& json) {
  std::vector<Eigen::Vector3d> points;
  for (const Json& vertex : json.at("vertices")) {
    points.push_back(vectorOf(vertex));
  }
  return ConvexHull(points);
}

PeerGeometry geometryOf(const Json& json) {
  const std::string type = json.at("type");
  if (type == "segment") {
    return segmentOf(json);
  }
  if (type == "halfspace") {
    return halfSpaceOf(json);
  }
  const Pose pose = poseOf(json.at("pose"));
  if (type == "sphere") {
    return {Sphere{json.at("radius").get<double>()}, pose};
  }
  if (type == "capsule") {
    return {Capsule{0.5 * json.at("length").get<double>(), json.at("radius")}, pose};
  }
  if (type == "box") {
    return {Box{0.5 * vectorOf(json.at("size"))}, pose};
  }
  if (type == "cylinder") {
    return {Cylinder{0.5 * json.at("length").get<double>(), json.at("radius")}, pose};
  }
  if (type == "convex" || type == "points" || type == "triangle") {
    return {hullOf(json), pose};
  }
  throw std::runtime_error("peer case with a geometry '" + type + "'");
}

template <class Value>
std::optional<Value> valueOf(const Json& json, const char* key) {
  return json.contains(key) && !json.at(key).is_null() && json.at(key).is_primitive()
             ? std::optional<Value>(json.at(key).get<Value>())
             : std::nullopt;
}

PeerExpectation expectationOf(const Json& json) {
  return {valueOf<double>(json, "distance"), valueOf<double>(json, "unsigned_distance"),
          valueOf<bool>(json, "collide"), json.value("margin", 0.0), json.value("tol", 0.0)};
}

Pose turned(const Json& about_z_deg, const Json& about_y_deg) {
  constexpr double kRadians = M_PI / 180.0;
  const Eigen::Quaterniond turn(
      Eigen::AngleAxisd(kRadians * about_z_deg.get<double>(), Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(kRadians * about_y_deg.get<double>(), Eigen::Vector3d::UnitY()));
  return {turn.toRotationMatrix(), Eigen::Vector3d::Zero()};
}

void addTurnedTriangles(const Json& family, std::vector<PeerCase>& cases) {
  const Json& grid = family.at("grid");
  for (const Json& i : grid.at("i")) {
    for (const Json& j : grid.at("j")) {
      for (const Json& k : grid.at("k")) {
        cases.push_back(
            {"coal-collision-node-asserts " + i.dump() + " " + j.dump() + " " + k.dump(),
             {hullOf(family.at("a")), turned(0, k)},
             {hullOf(family.at("b")), turned(i, j)},
             {}});
      }
    }
  }
}

void addSphereGrid(const Json& family, std::vector<PeerCase>& cases) {
  const auto sphereAt = [](double radius, double y) {
    return PeerGeometry{Sphere{radius}, {Eigen::Matrix3d::Identity(), {0.0, y, 0.0}}};
  };
  const Json& grid = family.at("grid");
  for (const double i : grid.at("i")) {
    for (const double z : grid.at("z")) {
      for (const double j : grid.at("j")) {
        for (const double rb : grid.at("rb")) {
          if (i != z) {
            PeerExpectation expect;
            expect.distance = std::abs(i - z) - j - 0.1 * rb;
            expect.tolerance = family.at("expect").at("tol");
            cases.push_back({"bullet-sphere-grid", sphereAt(j, i), sphereAt(0.1 * rb, z), expect});
          }
        }
      }
    }
  }
}

// Built as its author did: in single precision, with flat triangles at the poles and double
// vertices along a seam.
TriangleMesh sphereOfCoal(float radius) {
  constexpr std::uint32_t kSteps = 31;
  constexpr auto kPi = static_cast<float>(M_PI);
  TriangleMesh mesh;
  for (std::uint32_t p = 0; p <= kSteps; ++p) {
    for (std::uint32_t a = 0; a <= kSteps; ++a) {
      const float polar = static_cast<float>(p) * kPi / kSteps;
      const float around = static_cast<float>(a) * 2.0F * kPi / kSteps;
      mesh.vertices.push_back(
          (radius * Eigen::Vector3f(std::sin(polar) * std::cos(around),
                                    std::sin(polar) * std::sin(around), std::cos(polar)))
              .cast<double>());
    }
  }
  for (std::uint32_t p = 0; p < kSteps; ++p) {
    for (std::uint32_t a = 0; a < kSteps; ++a) {
      const std::uint32_t first = p * (kSteps + 1) + a;
      const std::uint32_t below = first + kSteps + 1;
      mesh.triangles.push_back({first, below + 1, first + 1});
      mesh.triangles.push_back({first, below, below + 1});
    }
  }
  return mesh;
}

std::optional<std::filesystem::path> peerFolder() {
  const auto shared = sharedDataDir();
  return shared && std::filesystem::is_directory(*shared / "peer_cases")
             ? std::optional(*shared / "peer_cases")
             : std::nullopt;
}

Json familyOf(const std::filesystem::path& folder, const std::string& id) {
  const Json parametric = Json::parse(readFile(folder / "parametric.json"));
  for (const Json& family : parametric.at("families")) {
    if (family.at("id") == id) {
      return family;
    }
  }
  throw std::runtime_error("no family '" + id + "' in " + folder.string());
}

}  // namespace

std::optional<std::vector<PeerCase>> convexPeerCases() {
  const auto folder = peerFolder();
  if (!folder) {
    return std::nullopt;
  }
  std::vector<PeerCase> cases;
  for (const auto& file : std::filesystem::directory_iterator(*folder)) {
    if (file.path().extension() != ".json") {
      continue;
    }
    const Json content = Json::parse(readFile(file.path()));
    for (const Json& entry : content.value("cases", Json::array())) {
      cases.push_back({entry.at("id"), geometryOf(entry.at("a")), geometryOf(entry.at("b")),
                       expectationOf(entry.at("expect"))});
    }
  }
  addTurnedTriangles(familyOf(*folder, "coal-collision-node-asserts"), cases);
  addSphereGrid(familyOf(*folder, "bullet-sphere-grid"), cases);
  return cases;
}

std::optional<PeerSpheres> sphereMeshPeerCases() {
  const auto folder = peerFolder();
  if (!folder) {
    return std::nullopt;
  }
  const Json family = familyOf(*folder, "coal-gjk-asserts");
  PeerSpheres spheres{
      sphereOfCoal(family.at("a").at("radius")), sphereOfCoal(family.at("b").at("radius")), {}};
  for (const Json& turn : family.at("i_j_deg")) {
    for (const Json& way : family.at("dirs")) {
      Pose pose = turned(turn.at(0), turn.at(1));
      pose.translation = vectorOf(way);
      spheres.cases.push_back({"coal-gjk-asserts " + turn.dump() + " " + way.dump(), pose});
    }
  }
  return spheres;
}

std::string differenceFrom(const PeerExpectation& expect, double distance, double slack) {
  const double allowed = expect.tolerance + slack;
  if (expect.distance && std::abs(distance - *expect.distance) > allowed) {
    return "expected distance " + std::to_string(*expect.distance);
  }
  if (expect.unsigned_distance &&
      std::abs(std::max(distance, 0.0) - *expect.unsigned_distance) > allowed) {
    return "expected unsigned distance " + std::to_string(*expect.unsigned_distance);
  }
  const double beyond = distance - expect.margin;
  if (expect.collide && std::abs(beyond) > allowed && *expect.collide != (beyond < 0.0)) {
    return std::string("expected collide = ") + (*expect.collide ? "true" : "false");
  }
  return "";
}

}  // namespace collision_monitor::test
