// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "urdf_fault.h"

namespace collision_monitor {
namespace {

using test::expectFaults;
using test::jointXml;
using test::robotXml;

// Which one is meant? The first won without a word.
TEST(UrdfFaults, whatStandsTwice) {
  const std::string shape = "<geometry><sphere radius='1'/></geometry>";
  const std::string links = "<link name='a'/><link name='b'/>";
  const auto of_link = [](const std::string& rest) {
    return robotXml("<link name='a'><collision>" + rest + "</collision></link>");
  };
  const auto of_joint = [&](const std::string& rest) {
    return robotXml(links + jointXml("j", "revolute", "a", "b", rest));
  };
  const std::string in_link = "test.urdf line 3, link 'a', collision 1: <collision> with a second ";
  const std::string in_joint = "test.urdf line 3, joint 'j': <joint> with a second ";
  expectFaults({
      {"geometry",
       of_link(shape + "\n<geometry><box size='1 1 1'/></geometry>"),
       {in_link +
        "<geometry>; accepted: one <geometry>; further ones in <collision> elements of their own"}},
      {"origin of a collision",
       of_link(shape + "<origin xyz='0 0 1'/>\n<origin/>"),
       {in_link + "<origin>; accepted: one <origin>"}},
      {"origin of a joint",
       of_joint("<origin/>\n<origin xyz='0 0 1'/>"),
       {in_joint + "<origin>; accepted: one <origin>"}},
      {"axis",
       of_joint("<axis xyz='1 0 0'/>\n<axis xyz='0 1 0'/>"),
       {in_joint + "<axis>; accepted: one <axis>"}},
      {"parent", of_joint("\n<parent link='b'/>"), {in_joint + "<parent>; accepted: one <parent>"}},
      {"child", of_joint("\n<child link='a'/>"), {in_joint + "<child>; accepted: one <child>"}},
  });
}

}  // namespace
}  // namespace collision_monitor
