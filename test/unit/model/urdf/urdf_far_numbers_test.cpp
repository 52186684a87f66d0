// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "urdf_fault.h"

namespace collision_monitor {
namespace {

using test::expectFaults;
using test::jointXml;
using test::linkXml;
using test::robotXml;

/// As far as poses from tf may be: what lies beyond would be no data in every cycle.
TEST(UrdfFarNumbers, areFaults) {
  const std::string at = "test.urdf line 2, link 'a', collision 1: ";
  const std::string links = "<link name='a'/><link name='b'/>\n";
  const std::string sphere = "<sphere radius='1'/>";
  const std::string lengths = "; accepted: three finite numbers separated by spaces, in metres";
  const std::string within = ", none beyond 1e9";
  const auto joint = [&](const std::string& rest) {
    return robotXml(links + jointXml("j", "revolute", "a", "b", rest));
  };
  const std::string at_joint = "test.urdf line 3, joint 'j': ";
  expectFaults({
      {"origin of a collision",
       robotXml(linkXml("a", sphere, "<origin xyz='0 -1.5e9 0'/>")),
       {at + "origin xyz '0 -1.5e9 0': '-1.5e9' is beyond 1e9" + lengths + within}},
      {"angle",
       robotXml(linkXml("a", sphere, "<origin rpy='1e155 0 0'/>")),
       {at +
        "origin rpy '1e155 0 0': '1e155' is beyond 1e9; accepted: three finite numbers "
        "separated by spaces, in radians" +
        within}},
      {"origin of a joint",
       joint("<origin xyz='1e10 0 0'/><limit lower='0' upper='1'/>"),
       {at_joint + "origin xyz '1e10 0 0': '1e10' is beyond 1e9" + lengths + within}},
      {"box",
       robotXml(linkXml("a", "<box size='1 1 2e9'/>")),
       {at +
        "box size '1 1 2e9': '2e9' is beyond 1e9; accepted: three numbers that are 0 or "
        "greater, in metres" +
        within}},
      {"sphere",
       robotXml(linkXml("a", "<sphere radius='1e300'/>")),
       {at +
        "sphere radius '1e300': '1e300' is beyond 1e9; accepted: one number that is 0 or "
        "greater, in metres" +
        within}},
      {"mimic",
       robotXml(links + "<link name='c'/>" + jointXml("j", "continuous", "a", "b") + "\n" +
                jointXml("k", "continuous", "a", "c", "<mimic joint='j' multiplier='-1e10'/>")),
       {"test.urdf line 4, joint 'k': mimic multiplier '-1e10': '-1e10' is beyond 1e9; accepted: "
        "one finite number" +
        within}},
      {"limits that leave nothing",
       joint("<limit lower='2e9' upper='1e16'/>"),
       {at_joint + "limit lower '2e9', upper '1e16'; accepted: a range that holds numbers within "
                   "1e9 of 0"}},
  });
}

}  // namespace
}  // namespace collision_monitor
