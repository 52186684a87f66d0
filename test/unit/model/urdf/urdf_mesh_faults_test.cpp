// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "urdf_fault.h"

namespace collision_monitor {
namespace {

using test::expectFaults;
using test::jointXml;
using test::linkXml;
using test::readText;
using test::ReadText;
using test::robotXml;

TEST(UrdfFaults, meshes) {
  const std::string at = "test.urdf line 2, link 'a', collision 1: ";
  const std::string files =
      "; accepted: a regular file that can be read, by package://PACKAGE/PATH, file:///PATH or a "
      "path";
  expectFaults({
      {"missing",
       robotXml(linkXml("a", "<mesh filename='package://p/x.stl'/>")),
       {at + "mesh 'package://p/x.stl': no file package://p/x.stl" + files}},
      {"relative",
       robotXml(linkXml("a", "<mesh filename='x.stl'/>")),
       {at +
        "mesh 'x.stl': a relative mesh name needs a description read from a "
        "file, or the monitor's mesh_directory" +
        files}},
      {"no name",
       robotXml(linkXml("a", "<mesh/>")),
       {at + "<mesh> without filename; accepted: filename=\"...\" that is not blank"}},
      {"flat scale, and missing",
       robotXml(linkXml("a", "<mesh filename='/x.stl' scale='1 0 1'/>")),
       {at + "mesh scale '1 0 1'; accepted: three numbers other than 0",
        at + "mesh '/x.stl': no file /x.stl" + files}},
      {"several for one reason",
       robotXml(linkXml("a", "<mesh filename='x.stl'/>") +
                linkXml("b", "<mesh filename='y.stl'/>") + jointXml("j", "fixed", "a", "b")),
       {"test.urdf: 2 meshes: a relative mesh name needs a description read from a file, or the "
        "monitor's mesh_directory: 'x.stl' in line 2, link 'a', collision 1; 'y.stl' in line 2, "
        "link "
        "'b', collision 1" +
        files}},
  });
}

TEST(UrdfFaults, manyMeshesForOneReason_areAFewAndHowManyMore) {
  std::string links = linkXml("a", "<mesh filename='x.stl'/>");
  for (int i = 0; i < 60; ++i) {
    const std::string name = "b" + std::to_string(i);
    links += linkXml(name, "<mesh filename='" + name + ".stl'/>") +
             jointXml("j" + name, "fixed", "a", name);
  }
  const ReadText read = readText(robotXml(links));
  ASSERT_EQ(read.errors().size(), 1U);
  const std::string error = read.errors()[0];
  EXPECT_EQ(error.rfind("test.urdf: 61 meshes: ", 0), 0U) << error;
  EXPECT_NE(error.find("; and 49 more; accepted: "), std::string::npos) << error;
}

// Which formats are read is said only of what stands in a file, and no name twice.
TEST(UrdfFaults, meshFiles) {
  const ReadText read = readText(robotXml(linkXml("a", "<mesh filename='/x.stl'/>")),
                                 {{"/x.stl", "solid x\nendsolid x\n"}});
  ASSERT_EQ(read.errors().size(), 1U);
  const std::string start = "test.urdf line 2, link 'a', collision 1: mesh '/x.stl': ";
  const std::string end = "; accepted: a mesh file that can be read: STL, DAE, OBJ or PLY";
  const std::string error = read.errors()[0];
  EXPECT_EQ(error.substr(0, start.size()), start) << error;
  EXPECT_EQ(error.find("/x.stl", start.size()), std::string::npos) << error;
  EXPECT_EQ(error.substr(error.size() - end.size()), end) << error;
}

}  // namespace
}  // namespace collision_monitor
