// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs/markup_text.h"

#include <gtest/gtest.h>

namespace collision_monitor::fit_tool {
namespace {

TEST(Escaped, whatMarkupWouldRead) {
  EXPECT_EQ(escaped("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(escaped("\x01 tab\t"), "? tab\t");
  EXPECT_EQ(escaped("\xc3\xa4"), "\xc3\xa4");  // UTF-8 passes
}

/// The examples of RFC 4648, section 10, and bytes that are no ASCII.
TEST(Base64, examplesOfTheRfc) {
  EXPECT_EQ(base64Of(""), "");
  EXPECT_EQ(base64Of("f"), "Zg==");
  EXPECT_EQ(base64Of("fo"), "Zm8=");
  EXPECT_EQ(base64Of("foo"), "Zm9v");
  EXPECT_EQ(base64Of("foob"), "Zm9vYg==");
  EXPECT_EQ(base64Of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64Of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64Of("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace collision_monitor::fit_tool
