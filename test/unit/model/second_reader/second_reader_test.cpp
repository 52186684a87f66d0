// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/second_reader/second_reader.h"

#include <console_bridge/console.h>
#include <gtest/gtest.h>

#include "support/robots/file_loader.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

using Texts = std::vector<std::string>;

const std::string kLinks =
    linkXml("a", "<box size='0.1 0.2 0.3'/>") + linkXml("b", "<sphere radius='0.1'/>") +
    linkXml("c", "<cylinder radius='0.1' length='0.5'/>", "<origin xyz='0 0 1' rpy='0 0.5 3'/>");
const std::string kLimit = "<limit lower='-1' upper='2' effort='1' velocity='3'/>";
const std::string kJoints =
    jointXml("j", "revolute", "a", "b", "<axis xyz='0 0 1'/>" + kLimit) +
    jointXml("k", "prismatic", "a", "c",
             "<origin xyz='1 2 3'/><mimic joint='j' multiplier='2' offset='1'/>" + kLimit);
const std::string kRobot = kLinks + kJoints;

/// What the second reader says of a model that was read from one text, while it reads another.
Texts differencesOf(const std::string& ours, const std::string& theirs,
                    const std::string& prefix = "") {
  RobotDescription description = describeText(robotXml(ours));
  description.tf_prefix = prefix;
  SetupReport report;
  const RobotModel model = readRobots({description}, oneTriangleLoader(), report);
  EXPECT_TRUE(report.errors.empty()) << toString(report.errors.front());
  description.urdf_xml = robotXml(theirs);
  Texts texts;
  for (const Problem& problem : askSecondReader({description}, model)) {
    EXPECT_EQ(problem.advice, "write it so that both read it alike");
    texts.push_back(problem.where + ": " + problem.found);
  }
  return texts;
}

Texts differencesOf(const std::string& robot) { return differencesOf(robot, robot); }

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

/// The only difference where a part of the robot's text is read otherwise.
std::string differenceFor(const std::string& part, const std::string& by) {
  const Texts texts = differencesOf(kRobot, replaced(kRobot, part, by));
  EXPECT_EQ(texts.size(), 1U) << by;
  return texts.empty() ? "" : texts.front();
}

TEST(SecondReader, sameReading_isNoWarning) {
  EXPECT_EQ(differencesOf(kRobot), Texts());
  EXPECT_EQ(differencesOf(kRobot, kRobot, "left"), Texts());
}

TEST(SecondReader, everyPropertyOfAJoint_isCompared) {
  EXPECT_EQ(differenceFor("'j' type='revolute'", "'j' type='prismatic'"),
            "test.urdf, joint 'j': type revolute as it is read here, type prismatic as urdfdom "
            "reads it");
  EXPECT_EQ(differenceFor("<axis xyz='0 0 1'/>", "<axis xyz='0 1 0'/>"),
            "test.urdf, joint 'j': axis 0 0 1 as it is read here, axis 0 1 0 as urdfdom reads it");
  EXPECT_EQ(differenceFor("xyz='1 2 3'", "xyz='1 2 3.001'"),
            "test.urdf, joint 'k': origin xyz 1 2 3 rpy 0 0 0 as it is read here, origin xyz 1 2 "
            "3.001 rpy 0 0 0 as urdfdom reads it");
  EXPECT_EQ(differenceFor("upper='2'", "upper='2.5'"),
            "test.urdf, joint 'j': upper limit 2 as it is read here, upper limit 2.5 as urdfdom "
            "reads it");
  EXPECT_EQ(differenceFor("lower='-1'", "lower='-1.5'"),
            "test.urdf, joint 'j': lower limit -1 as it is read here, lower limit -1.5 as urdfdom "
            "reads it");
  EXPECT_EQ(differenceFor("velocity='3'", "velocity='4'"),
            "test.urdf, joint 'j': velocity limit 3 as it is read here, velocity limit 4 as "
            "urdfdom reads it");
  EXPECT_EQ(differenceFor("multiplier='2'", "multiplier='-2'"),
            "test.urdf, joint 'k': mimic of 'j' by 2 and 1 as it is read here, mimic of 'j' by -2 "
            "and 1 as urdfdom reads it");
  EXPECT_EQ(
      differenceFor("<parent link='a'/><child link='c'/>", "<parent link='b'/><child link='c'/>"),
      "test.urdf, joint 'k': parent 'a' as it is read here, parent 'b' as urdfdom reads it");
}

TEST(SecondReader, shapes_areCompared) {
  EXPECT_EQ(differenceFor("size='0.1 0.2 0.3'", "size='0.1 0.2 0.4'"),
            "test.urdf, link 'a', collision 'collision_0': box 0.1 0.2 0.3 at xyz 0 0 0 rpy 0 0 0 "
            "as it is read here, box 0.1 0.2 0.4 at xyz 0 0 0 rpy 0 0 0 as urdfdom reads it");
  EXPECT_EQ(differenceFor("rpy='0 0.5 3'", "rpy='0 0.5 2'"),
            "test.urdf, link 'c', collision 'collision_0': cylinder of radius 0.1 and length 0.5 "
            "at xyz 0 0 1 rpy 0 0.5 3 as it is read here, cylinder of radius 0.1 and length 0.5 at "
            "xyz 0 0 1 rpy 0 0.5 2 as urdfdom reads it");
  EXPECT_EQ(differenceFor("<sphere radius='0.1'/>", "<sphereoid radius='0.1'/>"),
            "test.urdf, link 'b': 1 collision shapes as it is read here, 0 collision shapes as "
            "urdfdom reads it");
  const std::string mesh = linkXml("m", "<mesh filename='package://p/m.stl' scale='1 2 3'/>");
  EXPECT_EQ(differencesOf(mesh), Texts());
  EXPECT_EQ(differencesOf(mesh, replaced(mesh, "m.stl' scale='1 2 3'", "n.stl' scale='1 2 4'")),
            Texts{"test.urdf, link 'm', collision 'collision_0': mesh 'package://p/m.stl' of scale "
                  "1 2 3 at "
                  "xyz 0 0 0 rpy 0 0 0 as it is read here, mesh 'package://p/n.stl' of scale 1 2 4 "
                  "at xyz 0 0 "
                  "0 rpy 0 0 0 as urdfdom reads it"});
}

TEST(SecondReader, linksAndJointsThatOneLacks_areTold) {
  const std::string more = linkXml("d", "<sphere radius='1'/>") + jointXml("l", "fixed", "c", "d");
  EXPECT_EQ(differencesOf(kRobot, kRobot + more),
            (Texts{"test.urdf, link 'd': no link as it is read here, a link as urdfdom reads it",
                   "test.urdf, joint 'l': no joint as it is read here, a joint as urdfdom reads "
                   "it"}));
  EXPECT_EQ(differencesOf(kRobot + more, kRobot),
            (Texts{"test.urdf, link 'd': a link as it is read here, no link as urdfdom reads it",
                   "test.urdf, joint 'l': a joint as it is read here, no joint as urdfdom reads "
                   "it"}));
}

TEST(SecondReader, whatIsMeantToDiffer_isNoWarning) {
  const std::string tail = linkXml("d", "<box size='0 1 1'/>");
  const std::string robots[] = {
      linkXml("a", "<capsule radius='0.1' length='1'/>"),
      "<link name='a'><collision><geometry><box size='1 1 1'/></geometry></collision><collision>"
      "<geometry><cylinder radius='0.1' length='1'/></geometry></collision><collision><origin "
      "xyz='0 0 0.5'/><geometry><sphere radius='0.1'/></geometry></collision><collision><origin "
      "xyz='0 0 -0.5'/><geometry><sphere radius='0.1'/></geometry></collision><collision><geometry>"
      "<sphere radius='0.3'/></geometry></collision></link>",
      kLinks + replaced(kJoints, "xyz='0 0 1'", "xyz='0 0 5'"),
      replaced(kRobot, "velocity='3'", "velocity='0'"),
      replaced(kRobot, "velocity='3'", "velocity='-1'"),
      replaced(kRobot, "upper='2'", "upper='1e12'"),
      replaced(kRobot, "joint='j'", "joint='nowhere'"),
      kRobot + tail + jointXml("l", "fixed", "c", "d", "<mimic joint='j'/>"),
      kRobot + tail + jointXml("l", "revolute", "c", "d", "<mimic joint='k' offset='3'/>" + kLimit),
      replaced(replaced(kRobot, "<link name='b'>", "<link name='/b'>"), "child link='b'",
               "child link='/b'"),
  };
  for (const std::string& robot : robots) {
    EXPECT_EQ(differencesOf(robot), Texts()) << robot;
  }
}

// urdfdom leaves a link at its first capsule.
TEST(SecondReader, shapeBesideACapsule_isComparedWhereUrdfdomHasIt) {
  const std::string capsule =
      "<collision><geometry><capsule radius='0.1' length='1'/></geometry></collision>";
  const std::string ball = "<collision><geometry><sphere radius='0.2'/></geometry></collision>";
  EXPECT_EQ(differencesOf("<link name='a'>" + capsule + ball + "</link>"), Texts());
  const std::string robot = "<link name='a'>" + ball + capsule + "</link>";
  EXPECT_EQ(differencesOf(robot), Texts());
  EXPECT_EQ(differencesOf(robot, replaced(robot, "'0.2'", "'0.3'")),
            Texts{"test.urdf, link 'a', collision 'collision_0': sphere of radius 0.2 at xyz 0 0 0 "
                  "rpy 0 0 0 as it is read here, no such shape as urdfdom reads it"});
}

TEST(SecondReader, manyDifferences_areAFewAndHowManyMore) {
  std::string links;
  for (int i = 0; i < 100; ++i) {
    links += linkXml("l" + std::to_string(i), "<sphere radius='1'/>") +
             jointXml("j" + std::to_string(i), "fixed", "a", "l" + std::to_string(i));
  }
  RobotDescription description = describeText(robotXml(kRobot));
  SetupReport report;
  const RobotModel model = readRobots({description}, textLoader({}), report);
  description.urdf_xml = robotXml(kRobot + links);
  const std::vector<Problem> problems = askSecondReader({description}, model);
  ASSERT_EQ(problems.size(), 13U);
  EXPECT_EQ(toString(problems.back()), "test.urdf: 188 more that urdfdom reads otherwise");
}

// What urdfdom refuses, throws at, recurses in or would hang on.
TEST(SecondReader, textsThatAreNothingForUrdfdom_getNoSecondOpinion) {
  std::string attributes = "<link name='q'";
  for (int i = 0; i < 100'000; ++i) {
    attributes += " a" + std::to_string(i) + "=''";
  }
  for (const std::string& text :
       {std::string(), std::string("<link"), kLinks, "\xEF" + kRobot,
        kRobot + "<!-- \xEF\x80\x80 -->", kRobot + std::string(1, '\0'), attributes + "/>",
        std::string("<joint/>"), kRobot + "<link name='a'/>",
        replaced(kRobot, "upper='2'", "upper='two'")}) {
    EXPECT_EQ(differencesOf(kRobot, text), Texts()) << text.substr(0, 80);
  }
}

TEST(SecondReader, longChain_getsNoSecondOpinionAndDoesNoHarm) {
  for (const int links : {1900, 5000}) {
    std::string chain = "<link name='l0'/>";
    for (int i = 1; i < links; ++i) {
      const std::string name = "l" + std::to_string(i);
      chain += "<link name='" + name + "'/>" +
               jointXml("j" + std::to_string(i), "fixed", "l" + std::to_string(i - 1), name);
    }
    EXPECT_EQ(
        differencesOf(chain, replaced(chain, "'j1' type='fixed'", "'j1' type='floating'")).size(),
        links < 2000 ? 1U : 0U);
  }
}

/// Remembers what it was told.
class Listener final : public console_bridge::OutputHandler {
 public:
  Listener() { console_bridge::useOutputHandler(this); }
  ~Listener() override { console_bridge::restorePreviousOutputHandler(); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  void log(const std::string& text, console_bridge::LogLevel /*level*/, const char* /*file*/,
           int /*line*/) override {
    texts.push_back(text);
  }
  Texts texts;
};

TEST(SecondReader, itsLog_isKeptQuietAndLeftAsItWas) {
  Listener listener;
  differencesOf(kRobot, "<link/>");
  EXPECT_TRUE(listener.texts.empty()) << listener.texts.front();
  EXPECT_EQ(console_bridge::getOutputHandler(), &listener);
  CONSOLE_BRIDGE_logError("heard");
  EXPECT_EQ(listener.texts, Texts{"heard"});
}

}  // namespace
}  // namespace collision_monitor::test
