// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edit_srdf.h"

#include <gtest/gtest.h>

#include "srdf_scene.h"

namespace collision_monitor::pairs_tool {
namespace {

const std::string kFirst = disable("a", "b", "Adjacent");
const std::string kSecond = disable("c", "d", "Never");

std::string merged(const std::string& srdf) { return SrdfScene().merge(srdf).text; }

TEST(EditSrdf, emptyRoot_isOpened) {
  EXPECT_EQ(merged("<robot name=\"r\"/>"),
            "<robot name=\"r\">\n  " + kFirst + "\n  " + kSecond + "\n</robot>");
  EXPECT_EQ(merged("  <robot name='r' />\r\n<!-- end -->"), "  <robot name='r' >\r\n    " + kFirst +
                                                                "\r\n    " + kSecond +
                                                                "\r\n  </robot>\r\n<!-- end -->");
}

TEST(EditSrdf, rootOnOneLine) {
  EXPECT_EQ(merged("<robot name='r'></robot>\n"),
            "<robot name='r'>\n  " + kFirst + "\n  " + kSecond + "\n</robot>\n");
  EXPECT_EQ(merged("<robot name='r'>" + kFirst + "</robot>"),
            "<robot name='r'>" + kFirst + "\n" + kSecond + "</robot>");
}

TEST(EditSrdf, endsOfLines_indentation_byteOrderMark_areThoseOfTheFile) {
  const std::string unix_text = "<robot name='r'>\n\t\t" + kFirst + "\n</robot>\n";
  const std::string unix_result =
      "<robot name='r'>\n\t\t" + kFirst + "\n\t\t" + kSecond + "\n</robot>\n";
  EXPECT_EQ(merged(unix_text), unix_result);
  EXPECT_EQ(merged(replaced(unix_text, "\n", "\r\n")), replaced(unix_result, "\n", "\r\n"));
  EXPECT_EQ(merged(replaced(unix_text, "\n", "\r")), replaced(unix_result, "\n", "\r"));
  EXPECT_EQ(merged("\xEF\xBB\xBF" + unix_text), "\xEF\xBB\xBF" + unix_result);
  const std::string late = "<!-- first -->\n<?xml version=\"1.0\"?>\n";
  EXPECT_EQ(merged(late + unix_text), late + unix_result);
  EXPECT_EQ(merged("\n <?xml version='1.0'?>" + unix_text),
            "\n <?xml version='1.0'?>" + unix_result);
}

TEST(EditSrdf, whatOnlyLooksLikeALine_isText) {
  const std::string fake = disable("a", "c", "Never");
  const std::string former =
      "<robot name='r'>\n<!-- " + fake + " -->\n<![CDATA[" + fake + "]]>\n<group name='>'>" + fake +
      "</group>\n<end_effector name='/>&lt;disable_collisions/>'/>\n</robot>";
  EXPECT_EQ(merged(former),
            replaced(former, "\n</robot>", "\n" + kFirst + "\n" + kSecond + "\n</robot>"));
}

TEST(EditSrdf, takenOut_withItsLine_onlyWhereItHasOneForItself) {
  const std::string out = disable("a", "c", "Never");
  const std::string longer =
      "<disable_collisions link1='b'\n  link2='d' reason='Always'>\n"
      "  <!-- old -->\n</disable_collisions>";
  const std::string there = kFirst + kSecond;
  EXPECT_EQ(merged("<robot name='r'>" + there + "\n  " + out + " \n" + longer + "\n\n</robot>"),
            "<robot name='r'>" + there + "\n\n</robot>");
  EXPECT_EQ(merged("<robot name='r'>" + kFirst + out + kSecond + "</robot>"),
            "<robot name='r'>" + there + "</robot>");
  EXPECT_EQ(merged("<robot name='r'>\n" + out + " <!-- why -->\n" + there + "\n</robot>"),
            "<robot name='r'>\n <!-- why -->\n" + there + "\n</robot>");
}

TEST(EditSrdf, severalOnALine_someGoAndOthersCome) {
  const std::string out = disable("a", "c", "Never");
  EXPECT_EQ(merged("<robot name='r'>\n " + kFirst + out + " " + out + "\n</robot>"),
            "<robot name='r'>\n " + kFirst + " \n " + kSecond + "\n</robot>");
  EXPECT_EQ(merged("<robot name='r'>" + kFirst + out + "</robot>"),
            "<robot name='r'>" + kFirst + "\n" + kSecond + "</robot>");
  EXPECT_EQ(merged("<robot name='r'>\n  " + out + "\n</robot>"),
            "<robot name='r'>\n  " + kFirst + "\n  " + kSecond + "\n</robot>");
}

TEST(EditSrdf, behindTheLastLine_whereAPartGoesOn) {
  const std::string open = "<group name='g'>\n</group>\n</robot>";
  EXPECT_EQ(merged("<robot name='r'>\n " + kFirst + open),
            "<robot name='r'>\n " + kFirst + "\n " + kSecond + open);
}

}  // namespace
}  // namespace collision_monitor::pairs_tool
