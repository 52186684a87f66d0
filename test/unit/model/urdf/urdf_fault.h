// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/robots/urdf_text.h"

namespace collision_monitor::test {

/// A bad description and everything that must be said about it.
struct Fault {
  const char* what;
  std::string xml;
  std::vector<std::string> errors;
};

inline void expectFaults(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    const ReadText read = readText(fault.xml);
    EXPECT_EQ(read.errors(), fault.errors) << fault.what;
    EXPECT_TRUE(read.model.links.empty()) << fault.what << ": half a model was returned";
  }
}

}  // namespace collision_monitor::test
