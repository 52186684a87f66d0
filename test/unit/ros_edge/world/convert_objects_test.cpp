// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/convert_objects.h"

#include <gtest/gtest.h>

#include "ros_edge/world/world_parameters.h"
#include "support/robots/file_loader.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

using Texts = std::vector<std::string>;

std::vector<ObjectChange> read(const std::vector<SceneChange>& messages, SetupReport& report) {
  MeshReading reading;
  reading.is_in_process = true;
  const ResourceLoader loader = oneTriangleLoader();
  return fromMessages(messages, {loader, reading}, report);
}

TEST(ConvertObjects, anObjectThatIsListed_canBeAddedAgain) {
  auto wedge = std::make_shared<TriangleMesh>();
  wedge->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  wedge->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  WorldObject object = attached(objectOf("tool", Sphere{0.1}, at(1, 2, 3)), "hand", {"finger"});
  object.shapes =
      std::make_shared<const ObjectShapes>(ObjectShapes{{at(0, 0, 1), Sphere{0.1}},
                                                        {at(0, 0, 2), Capsule{0.2, 0.3}},
                                                        {at(0, 0, 3), Box{{1, 2, 3}}},
                                                        {at(0, 0, 4), Cylinder{0.4, 0.5}},
                                                        {at(0, 0, 5), Cone{0.6, 0.7}},
                                                        {at(0, 0, 6), SharedMesh(wedge)},
                                                        {at(0, 0, 7), Plane{{0, 1, 0}, 0.8}}});
  object.padding = 0.01;
  object.group = "tools";
  object.colour = {0.1F, 0.2F, 0.3F, 0.4F};
  SceneChange message;
  message.objects.emplace_back();
  toMessage(object, message.objects.back());
  SetupReport report;
  const std::vector<ObjectChange> changes = read({message}, report);
  EXPECT_EQ(textsOf(report.errors), Texts());
  ASSERT_EQ(changes.size(), 1U);
  const WorldObject& again = changes[0].objects.at(0);
  EXPECT_EQ(again.name, "tool");
  EXPECT_EQ(again.frame, "hand");
  EXPECT_TRUE(again.is_attached);
  EXPECT_EQ(again.touch_links, object.touch_links);
  EXPECT_EQ(again.padding, object.padding);
  EXPECT_EQ(again.group, object.group);
  EXPECT_EQ(again.colour, object.colour);
  EXPECT_EQ(again.frame_from_object.translation, object.frame_from_object.translation);
  ASSERT_EQ(again.shapes->size(), object.shapes->size());
  for (std::size_t i = 0; i < object.shapes->size(); ++i) {
    const ObjectShape& shape = again.shapes->at(i);
    EXPECT_EQ(shape.geometry.index(), object.shapes->at(i).geometry.index());
    EXPECT_EQ(shape.object_from_shape.translation.z(), static_cast<double>(i + 1));
  }
  EXPECT_EQ(std::get<Capsule>(again.shapes->at(1).geometry).half_length, 0.2);
  EXPECT_EQ(std::get<SharedMesh>(again.shapes->at(5).geometry)->triangles, wedge->triangles);
  EXPECT_EQ(std::get<Plane>(again.shapes->at(6).geometry).offset, 0.8);
}

TEST(ConvertObjects, faultsThatOnlyMessagesHave_areNamedAllAtOnce) {
  SceneObject object;
  object.name = "a";
  object.primitives.resize(2);
  object.primitives[0].type = shape_msgs::SolidPrimitive::BOX;
  object.primitives[1].type = 9;
  object.mesh_files = {"file:///one.xyz"};
  SceneChange change;
  change.objects = {object};
  SceneChange unknown;
  unknown.kind = 7;
  SetupReport report;
  read({change, unknown}, report);
  const Texts errors = textsOf(report.errors);
  ASSERT_EQ(errors.size(), 5U);
  EXPECT_EQ(errors[0],
            "change 1 (add), object 'a': orientation 0 0 0 0; accepted: a unit quaternion; 0 0 0 1 "
            "for none");
  EXPECT_EQ(errors[1],
            "change 1 (add), object 'a', primitive 1: 0 dimensions; accepted: 3 of a box, 1 of a "
            "sphere, 2 of a cylinder, cone or capsule");
  EXPECT_EQ(errors[2],
            "change 1 (add), object 'a', primitive 2: type 9; accepted: 1 (box), 2 (sphere), 3 "
            "(cylinder), 4 (cone) or 100 (capsule)");
  EXPECT_EQ(errors[3].rfind("change 1 (add), object 'a', mesh file 1: ", 0), 0U) << errors[3];
  EXPECT_EQ(errors[4], "change 2: kind 7; accepted: from 0 (ADD) to 6 (DETACH)");
}

TEST(ConvertObjects, aFile_isReadAndScaled) {
  SceneObject object;
  object.name = "a";
  object.pose.orientation.w = 1.0;
  object.mesh_files = {"file:///one.stl"};
  object.mesh_scales.resize(1);
  object.mesh_scales[0].x = object.mesh_scales[0].y = object.mesh_scales[0].z = 2.0;
  SceneChange change;
  change.objects = {object};
  SetupReport report;
  const std::vector<ObjectChange> changes = read({change}, report);
  EXPECT_EQ(textsOf(report.errors), Texts());
  const auto& mesh = std::get<SharedMesh>(changes.at(0).objects.at(0).shapes->at(0).geometry);
  EXPECT_EQ(mesh->vertices.at(1).norm(), 2.0);
}

TEST(YamlOf, aParameter_isTextThatReadsBackAsTheSame) {
  XmlRpc::XmlRpcValue object;
  object["name"] = std::string("a \"b\"\\\n");
  object["padding"] = 0.1;
  object["is"] = true;
  object["xyz"][0] = 1;
  object["xyz"][1] = -2.5;
  EXPECT_EQ(yamlOf(object),
            "{\"is\": true, \"name\": \"a \\\"b\\\"\\\\\\u000a\", \"padding\": 0.1, \"xyz\": [1, "
            "-2.5]}");
}

}  // namespace
}  // namespace collision_monitor::test
