// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "model/world/world_text.h"
#include "support/robots/file_loader.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

using Texts = std::vector<std::string>;

struct Read {
  std::vector<WorldObject> objects;
  Texts errors;
};

Read readAs(const std::string& source, const std::string& text) {
  MeshReading reading;
  reading.is_in_process = true;
  SetupReport report;
  Read read;
  read.objects = readWorld({source, text, ""}, oneTriangleLoader(), reading, report);
  read.errors = textsOf(report.errors);
  return read;
}

template <class Kind>
const Kind& shapeOf(const WorldObject& object, std::size_t i = 0) {
  return std::get<Kind>(object.shapes->at(i).geometry);
}

TEST(ReadWorld, aGroundPlane_isOneLine) {
  const Read read = readAs("cell.yaml", "world: [{name: floor, kind: plane}]");
  EXPECT_EQ(read.errors, Texts());
  ASSERT_EQ(read.objects.size(), 1U);
  EXPECT_EQ(read.objects[0].name, "floor");
  EXPECT_EQ(read.objects[0].frame, "");
  EXPECT_EQ(shapeOf<Plane>(read.objects[0]).normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(shapeOf<Plane>(read.objects[0]).offset, 0.0);
}

TEST(ReadWorld, allKindsAndFields_areRead) {
  const Read read = readAs("cell.yaml",
                           "- {name: ball, kind: sphere, radius: 0.1, xyz: [1, 2, 3], frame: cam}\n"
                           "- name: tool\n"
                           "  attach: hand\n"
                           "  touch_links: [finger_1, finger_2]\n"
                           "  padding: 0.01\n"
                           "  group: tools\n"
                           "  colour: [1, 0.5, 0, 1]\n"
                           "  quat_xyzw: [0, 0, 1, 0]\n"
                           "  shapes:\n"
                           "    - {kind: box, size: [1, 2, 3], xyz: [0, 0, 1]}\n"
                           "    - {kind: cylinder, radius: 0.1, length: 0.4}\n"
                           "    - {kind: capsule, radius: 0.1, length: 0.6}\n"
                           "    - {kind: cone, radius: 0.1, length: 0.8}\n"
                           "    - {kind: mesh, file: file:///one.stl, scale: [2, 2, 2]}\n");
  EXPECT_EQ(read.errors, Texts());
  ASSERT_EQ(read.objects.size(), 2U);
  EXPECT_EQ(read.objects[0].frame, "cam");
  EXPECT_EQ(read.objects[0].frame_from_object.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(shapeOf<Sphere>(read.objects[0]).radius, 0.1);
  const WorldObject& tool = read.objects[1];
  EXPECT_TRUE(tool.is_attached);
  EXPECT_EQ(tool.frame, "hand");
  EXPECT_EQ(tool.touch_links, (Texts{"finger_1", "finger_2"}));
  EXPECT_EQ(tool.padding, 0.01);
  EXPECT_EQ(tool.group, "tools");
  EXPECT_EQ(tool.colour[1], 0.5F);
  EXPECT_EQ(tool.where, "cell.yaml line 2");
  EXPECT_TRUE(tool.frame_from_object.rotation.col(0).isApprox(-Eigen::Vector3d::UnitX()));
  ASSERT_EQ(tool.shapes->size(), 5U);
  EXPECT_EQ(shapeOf<Box>(tool).half_extents, Eigen::Vector3d(0.5, 1, 1.5));
  EXPECT_EQ(tool.shapes->at(0).object_from_shape.translation.z(), 1.0);
  EXPECT_EQ(shapeOf<Cylinder>(tool, 1).half_length, 0.2);
  EXPECT_EQ(shapeOf<Capsule>(tool, 2).half_length, 0.3);
  EXPECT_EQ(shapeOf<Cone>(tool, 3).half_length, 0.4);
  EXPECT_EQ(shapeOf<SharedMesh>(tool, 4)->triangles.size(), 1U);
}

TEST(ReadWorld, everyFaultOfALists_isNamedWithItsLine) {
  const Read read = readAs("cell.yaml",
                           "- {name: a, kind: ball}\n"
                           "- {name: b, kind: box}\n"
                           "- {name: c, kind: sphere, radius: wide}\n"
                           "- {name: d, kind: sphere, radius: 1, size: 2}\n"
                           "- {name: e, kind: plane, frame: f, attach: hand}\n"
                           "- {name: g}\n"
                           "- 7\n"
                           "- {name: h, kind: plane, quat_xyzw: [0, 0, 0, 0]}\n"
                           "- {name: i, shapes: []}\n");
  EXPECT_EQ(read.errors,
            (Texts{"cell.yaml line 1, object 1, 'a': kind 'ball'; accepted: sphere, capsule, box, "
                   "cylinder, cone, mesh or plane",
                   "cell.yaml line 2, object 2, 'b': kind 'box'; accepted: with size, in metres",
                   "cell.yaml line 3, object 3, 'c': radius 'wide'; accepted: a number from -1e+06 "
                   "to 1e+06",
                   "cell.yaml line 4, object 4, 'd': an unknown key, 'size'; accepted: attach, "
                   "colour, frame, group, kind, name, padding, quat_xyzw, radius, rpy, shapes, "
                   "touch_links and xyz",
                   "cell.yaml line 5, object 5, 'e': frame and attach; accepted: one of them",
                   "cell.yaml line 6, object 6, 'g': no kind; accepted: 'kind: box, size: [0.1, "
                   "0.2, 0.3]', or another kind: "
                   "sphere, capsule, box, cylinder, cone, mesh or plane",
                   "cell.yaml line 7, object 7: '7'; accepted: an object with its fields",
                   "cell.yaml line 8, object 8, 'h': quat_xyzw [0, 0, 0, 0]; accepted: a unit "
                   "quaternion",
                   "cell.yaml line 9, object 9, 'i': shapes []; accepted: a list of shapes, at "
                   "least one"}));
}

TEST(ReadWorld, textThatIsNoList_isOneFault) {
  EXPECT_EQ(readAs("a.yaml", "shapes: 1").errors.size(), 1U);
  EXPECT_EQ(readAs("a.yaml", "[").errors.size(), 1U);
  EXPECT_EQ(readAs("a.yaml", "").errors, Texts());
  EXPECT_EQ(readAs("a.yaml", "world: []").errors, Texts());
  EXPECT_EQ(readAs("a.yaml", "world: 5").errors,
            Texts{"a.yaml line 1: world '5'; accepted: YAML with a list of objects, alone or under "
                  "'world', or a planning scene of MoveIt"});
}

TEST(ReadWorld, textOfAMillionObjects_isRefusedUnread) {
  const Read read = readAs("cell.yaml", std::string(kMostWorldBytes + (1U << 20U), '#'));
  EXPECT_EQ(read.errors, Texts{"cell.yaml: 49 MB of text; accepted: at most 48 MB"});
  EXPECT_TRUE(read.objects.empty());
}

TEST(ReadWorld, aPlanningScene_givesObjectsAndAttachedOnes) {
  const Read read =
      readAs("scene.yaml",
             "robot_state:\n"
             "  attached_collision_objects:\n"
             "    - link_name: hand\n"
             "      touch_links: [finger]\n"
             "      object:\n"
             "        id: part\n"
             "        primitives: [{type: sphere, dimensions: [0.1]}]\n"
             "        primitive_poses:\n"
             "          - {position: [1, 2, 3], orientation: [0, 0, 0, 1]}\n"
             "world:\n"
             "  collision_objects:\n"
             "    - header: {frame_id: base_link}\n"
             "      id: Can1 \n"
             "      primitives:\n"
             "        - {type: cylinder, dimensions: [0.14, 0.03]}\n"
             "        - {type: 1, dimensions: [1, 2, 3]}\n"
             "      planes: [{coef: [0, 0, 1, -0.5]}]\n"
             "      meshes: [{resource: 'file:///one.stl', dimensions: [1, 1, 1]}]\n");
  EXPECT_EQ(read.errors, Texts());
  ASSERT_EQ(read.objects.size(), 2U);
  const WorldObject& can = read.objects[0];
  EXPECT_EQ(can.name, "Can1");
  EXPECT_EQ(can.frame, "base_link");
  ASSERT_EQ(can.shapes->size(), 4U);
  EXPECT_EQ(shapeOf<Cylinder>(can).half_length, 0.07);
  EXPECT_EQ(shapeOf<Cylinder>(can).radius, 0.03);
  EXPECT_EQ(shapeOf<Box>(can, 1).half_extents, Eigen::Vector3d(0.5, 1, 1.5));
  EXPECT_EQ(shapeOf<Plane>(can, 3).offset, 0.5);
  const WorldObject& part = read.objects[1];
  EXPECT_TRUE(part.is_attached);
  EXPECT_EQ(part.frame, "hand");
  EXPECT_EQ(part.touch_links, Texts{"finger"});
  EXPECT_EQ(part.shapes->at(0).object_from_shape.translation, Eigen::Vector3d(1, 2, 3));
}

TEST(ReadWorld, faultsOfAPlanningScene_areNamedWithTheirLines) {
  const Read read = readAs("scene.yaml",
                           "world:\n"
                           "  collision_objects:\n"
                           "    - id: a\n"
                           "      primitives: [{type: box, dimensions: [1, 2]}]\n"
                           "    - id: b\n"
                           "      primitives: [{type: sphere, dimensions: [1]}]\n"
                           "      primitive_poses: [{position: [0, 0, 0]}]\n"
                           "    - id: c\n"
                           "      primitives: [{dimensions: [1]}]\n"
                           "    - 3\n");
  EXPECT_EQ(read.errors,
            (Texts{"scene.yaml line 4, object 1, primitive 1: a primitive of type 'box' with "
                   "dimensions [1, 2]; accepted: box with 3 dimensions, sphere with 1, cylinder "
                   "or cone with 2",
                   "scene.yaml line 7, object 2, primitive 1: a pose that cannot be read; "
                   "accepted: position with three numbers and orientation with a unit quaternion",
                   "scene.yaml line 9, object 3, primitive 1: a primitive of type '' with "
                   "dimensions [1]; accepted: box with 3 dimensions, sphere with 1, cylinder or "
                   "cone with 2",
                   "scene.yaml line 10, object 4: '3'; accepted: an object with its fields"}));
  SetupReport report;
  applyChanges(World(), {{ChangeKind::add, {read.objects[0], read.objects[2]}, true}}, armPlaces(),
               report);
  EXPECT_EQ(textsOf(report.errors), Texts()) << "shapes that could not be read are told already";
}

TEST(ReadWorld, sceneTextOfBothFormats_isRead) {
  const Read older = readAs("a.scene",
                            "kitchen\n* table top\n1\nbox\n1 2 0.1\n0.5 0 1\n0 0 0 1\n"
                            "0.2 0.4 0.6 1\n.\n");
  EXPECT_EQ(older.errors, Texts());
  ASSERT_EQ(older.objects.size(), 1U);
  EXPECT_EQ(older.objects[0].name, "table top");
  EXPECT_EQ(shapeOf<Box>(older.objects[0]).half_extents, Eigen::Vector3d(0.5, 1, 0.05));
  EXPECT_EQ(older.objects[0].shapes->at(0).object_from_shape.translation.z(), 1.0);
  EXPECT_EQ(older.objects[0].colour[1], 0.4F);
  // A text without a file is known by its second line.
  const Read newer = readAs("world",
                            "kitchen\n* pot\n0 0 2\n0 0 0 1\n2\ncylinder\n0.1 0.3\n0 0 0\n"
                            "0 0 0 1\n0 0 0 0\nmesh\n3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n0 0 0\n"
                            "0 0 0 1\n0 0 0 0\n1\nlid\n0 0 1\n0 0 0 1\n* floor\n0 0 0\n0 0 0 1\n"
                            "1\nplane\n0 0 1 0.5\n0 0 0\n0 0 0 1\n0 0 0 0\n0\n.\n");
  EXPECT_EQ(newer.errors, Texts());
  ASSERT_EQ(newer.objects.size(), 2U);
  EXPECT_EQ(newer.objects[0].frame_from_object.translation.z(), 2.0);
  EXPECT_EQ(shapeOf<Cylinder>(newer.objects[0]).half_length, 0.15);
  EXPECT_EQ(shapeOf<SharedMesh>(newer.objects[0], 1)->vertices.size(), 3U);
  EXPECT_EQ(shapeOf<Plane>(newer.objects[1]).offset, -0.5);
}

TEST(ReadWorld, sceneTextThatEndsEarlyOrHasAFault_namesItsLine) {
  EXPECT_EQ(readAs("a.scene", "kitchen\n* table\n1\nbox\n1 2\n").errors,
            Texts{"a.scene line 5: the size of a box: 2 numbers; accepted: 3 finite numbers"});
  EXPECT_EQ(readAs("a.scene", "kitchen\n* table\n1\n").errors,
            Texts{"a.scene line 3: the end of the text; accepted: a kind of shape"});
  EXPECT_EQ(readAs("a.scene", "kitchen\n* t\n1\ntorus\n").errors,
            Texts{"a.scene line 4: shape 'torus'; accepted: sphere, box, cylinder, cone, plane or "
                  "mesh"});
}

}  // namespace
}  // namespace collision_monitor::test
