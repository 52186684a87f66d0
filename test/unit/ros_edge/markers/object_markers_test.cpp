// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ros_edge/markers/marker_shapes.h"
#include "ros_edge/markers/markers.h"
#include "ros_edge/markers/object_mesh.h"
#include "unit/ros_edge/draw_markers.h"
#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test {
namespace {

using visualization_msgs::Marker;

/// A ball of 20 * 2 * `rings` triangles, of radius 1.
TriangleMesh roundMesh(std::uint32_t rings) {
  constexpr std::uint32_t kSides = 20;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const double polar = 3.14159265 * i / rings;
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const double around = 2.0 * 3.14159265 * k / kSides;
      mesh.vertices.emplace_back(std::sin(polar) * std::cos(around),
                                 std::sin(polar) * std::sin(around), std::cos(polar));
      const std::uint32_t next = (k + 1) % kSides;
      if (i > 0) {
        const std::uint32_t above = (i - 1) * kSides;
        mesh.triangles.push_back({above + k, above + kSides + k, above + next});
        mesh.triangles.push_back({above + next, above + kSides + k, above + kSides + next});
      }
    }
  }
  return mesh;
}

class ObjectMarkers : public testing::Test {
 protected:
  /// The markers of objects, when base and tool are 0.3 m + reach apart.
  std::vector<Marker> draw(const std::vector<WorldObject>& objects, double reach = 0.5) {
    const auto setup = slidingSetupWith(objects);
    watch_ = judged(setup, store_, slidingPoses(setup->setup.model, 0.0, reach));
    std::vector<Marker> shown;
    for (const Marker& marker : drawFirst(*watch_).markers) {
      if (marker.ns == "objects") {
        shown.push_back(marker);
      }
    }
    return shown;
  }

  TransformStore store_;
  std::unique_ptr<Watch> watch_;
};

WorldObject coloured(WorldObject object, const ObjectColour& colour) {
  object.colour = colour;
  return object;
}

TEST_F(ObjectMarkers, areInTheirOwnColoursUntilTheyTouch) {
  const ObjectColour blue{0.1F, 0.2F, 0.9F, 0.8F};
  const auto far = draw({coloured(objectOf("part", Box{{0.1, 0.2, 0.3}}, at(0, 0, 3)), blue)});
  ASSERT_EQ(far.size(), 1U);
  EXPECT_EQ(far[0].type, Marker::CUBE);
  EXPECT_NEAR(far[0].scale.z, 0.6, 1e-12);
  EXPECT_EQ(far[0].color.b, 0.9F);
  EXPECT_EQ(far[0].color.a, 0.8F);
  EXPECT_NEAR(far[0].pose.position.z, 3.0, 1e-12);
  const auto touching =
      draw({coloured(objectOf("part", Box{{0.1, 0.2, 0.3}}, at(0, 0, 0.1)), blue)});
  ASSERT_EQ(touching.size(), 1U);
  EXPECT_EQ(touching[0].color.r, colourOf(Verdict::contact, 1.0F).r);
}

TEST_F(ObjectMarkers, thatAreAttached_moveWithTheirLink) {
  const WorldObject held = attached(objectOf("held", Sphere{0.05}, at(0, 0, 1)), "tool");
  const auto shown = draw({held}, 0.5);
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].type, Marker::SPHERE);
  EXPECT_NEAR(shown[0].pose.position.x, 1.0, 1e-12);
  EXPECT_NEAR(shown[0].pose.position.z, 1.0, 1e-12);
  EXPECT_NEAR(draw({held}, 0.7)[0].pose.position.x, 1.2, 1e-12);
}

TEST_F(ObjectMarkers, showTheGeometryAndNotTheShapeAroundIt) {
  TriangleMesh wedge;
  wedge.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  WorldObject object = objectOf("all", Cylinder{0.5, 0.1}, at(0, 0, 5));
  object.shapes = std::make_shared<const ObjectShapes>(
      ObjectShapes{{at(0, 0, 0), Cylinder{0.5, 0.1}},
                   {at(0, 0, 2), Cone{0.5, 0.1}},
                   {at(0, 0, 4), std::make_shared<const TriangleMesh>(wedge)},
                   {at(0, 0, 6), Capsule{0.2, 0.1}}});
  object.padding = 0.01;
  const auto shown = draw({object});
  ASSERT_EQ(shown.size(), 4U);
  EXPECT_EQ(shown[0].type, Marker::CYLINDER);
  EXPECT_NEAR(shown[0].scale.x, 2.0 * 0.11, 1e-12) << "with its padding";
  EXPECT_NEAR(shown[0].scale.z, 2.0 * 0.51, 1e-12);
  EXPECT_EQ(shown[1].points.size(), 3U * 64U) << "32 sides, and the base";
  EXPECT_EQ(shown[2].points.size(), 3U * 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(shown[i].pose.position.z, 5.0 + 2.0 * static_cast<double>(i), 1e-12);
  }
}

TEST_F(ObjectMarkers, ofAPlane_endAtItsSurface) {
  const auto shown = draw({objectOf("floor", Plane{{0, 0, 1}, 0.0}, at(0, 0, -9))});
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].type, Marker::CUBE);
  EXPECT_NEAR(shown[0].pose.position.z + 0.5 * shown[0].scale.z, -9.0, 3e-4);
}

TEST(CoarseMesh, ofManyTriangles_hasFewAndTheSameSize) {
  const TriangleMesh fine = roundMesh(1000);
  ASSERT_EQ(fine.triangles.size(), 40000U);
  const TriangleMesh coarse = coarseMesh(fine, 2000);
  EXPECT_LE(coarse.triangles.size(), 2000U);
  EXPECT_GT(coarse.triangles.size(), 200U);
  double highest = 0.0;
  for (const Eigen::Vector3d& vertex : coarse.vertices) {
    EXPECT_NEAR(vertex.norm(), 1.0, 1e-9) << "vertices are those of the mesh";
    highest = std::max(highest, vertex.z());
  }
  EXPECT_GT(highest, 0.9);
}

TEST(CoarseMesh, tinyAndFarFromTheOrigin_keepsItsShape) {
  TriangleMesh fine = roundMesh(1000);
  for (Eigen::Vector3d& vertex : fine.vertices) {
    vertex = 1e-4 * vertex + Eigen::Vector3d(9e5, -9e5, 9e5);
  }
  EXPECT_GT(coarseMesh(fine, 2000).triangles.size(), 200U);
}

TEST(CoarseMesh, ofManyTrianglesInOnePoint_isEmpty) {
  TriangleMesh mesh = roundMesh(1000);
  mesh.vertices.assign(mesh.vertices.size(), {1.0, 2.0, 3.0});
  EXPECT_TRUE(coarseMesh(mesh, 2000).triangles.empty());
}

TEST(CoarseMesh, ofFewTriangles_isTheMesh) {
  EXPECT_EQ(coarseMesh(roundMesh(5), 200).triangles, roundMesh(5).triangles);
}

World meshesOf(std::size_t count, std::uint32_t rings) {
  World world;
  for (std::size_t i = 0; i < count; ++i) {
    WorldObject object = named("mesh_" + std::to_string(i));
    object.shapes = std::make_shared<const ObjectShapes>(
        ObjectShapes{{Pose(), SharedMesh(std::make_shared<const TriangleMesh>(roundMesh(rings)))}});
    world.objects[object.name] = std::make_shared<const WorldObject>(object);
  }
  return world;
}

std::size_t trianglesOf(const DrawnMeshes& meshes) {
  std::size_t count = 0;
  for (const auto& one : meshes) {
    count += one.second.drawn->triangles.size();
  }
  return count;
}

TEST(DrawMeshes, ofManyMeshes_sharesOneBudget) {
  const std::size_t of_few = trianglesOf(drawMeshes(meshesOf(2, 90), {}));
  EXPECT_EQ(of_few, 2U * 40U * 90U) << "each is drawn whole";
  const std::size_t of_many = trianglesOf(drawMeshes(meshesOf(100, 90), {}));
  EXPECT_LE(of_many, kMostDrawnOfAll);
  EXPECT_GT(of_many, kMostDrawnOfAll / 8);
}

TEST(DrawMeshes, thatStay_areNotMadeAgain) {
  World world = meshesOf(2, 200);
  const DrawnMeshes before = drawMeshes(world, {});
  world.objects.erase("mesh_1");
  const DrawnMeshes after = drawMeshes(world, before);
  ASSERT_EQ(after.size(), 1U);
  const auto& [mesh, drawn] = *after.begin();
  EXPECT_EQ(drawn.drawn, before.at(mesh).drawn);
  EXPECT_LE(drawn.drawn->triangles.size(), kMostDrawn);
}

TEST(DrawMeshes, ofMoreMeshesThanCanBeShown_leavesBoxes) {
  for (const auto& one : drawMeshes(meshesOf(3000, 3), {})) {
    EXPECT_TRUE(one.second.drawn->triangles.empty());
  }
}

}  // namespace
}  // namespace collision_monitor::test
