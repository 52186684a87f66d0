// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/file_parameters.h"

#include <gtest/gtest.h>

#include "ros_edge/parameters/parameters.h"

namespace collision_monitor::test {
namespace {

using XmlRpc::XmlRpcValue;

TEST(FileParameters, nothingSet_onlyFilesAreRead) {
  SetupReport report;
  const Parameters parameters = readParameters(XmlRpcValue(), "/m", report);
  EXPECT_TRUE(parameters.loading.schemes.empty());
  EXPECT_EQ(parameters.loading.max_size, kUsualFileSize);
  EXPECT_FALSE(parameters.setup.meshes.is_in_process);
}

TEST(FileParameters, valuesAreRead) {
  XmlRpcValue values;
  values["files"]["max_size"] = 1000;
  values["files"]["schemes"][0] = "http";
  values["files"]["schemes"][1] = "https";
  values["files"]["download_time"] = 2.5;
  values["files"]["mesh_time"] = 7;
  values["files"]["mesh_memory"] = 3e9;
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(parameters.loading.max_size, 1000U);
  EXPECT_EQ(parameters.loading.schemes, (std::vector<std::string>{"http", "https"}));
  EXPECT_EQ(parameters.loading.download_time, 2.5);
  EXPECT_EQ(parameters.setup.meshes.seconds, 7.0);
  EXPECT_EQ(parameters.setup.meshes.memory, 3e9);
}

TEST(FileParameters, allFaultsAreReported_andChangeNothing) {
  XmlRpcValue values;
  values["files"]["max_size"] = 0;
  values["files"]["schemes"][0] = "http://";
  values["files"]["schemes"][1] = 7;
  values["files"]["schemes"][2] = "HTTP";
  values["files"]["download_time"] = 0;
  values["files"]["mesh_time"] = -1;
  values["files"]["mesh_memory"] = 5;
  values["files"]["max_sise"] = 5;
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_EQ(report.errors.size(), 8U);
  for (const Problem& problem : report.errors) {
    EXPECT_EQ(problem.where.rfind("parameter /m/files/", 0), 0U) << problem.where;
  }
  EXPECT_TRUE(parameters.loading.schemes.empty());
  EXPECT_EQ(parameters.loading.max_size, kUsualFileSize);
}

TEST(FileParameters, schemesThatAreNoList_areOneFault) {
  XmlRpcValue values;
  values["files"]["schemes"] = "http";
  SetupReport report;
  readParameters(values, "/m", report);
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_EQ(toString(report.errors[0]),
            "parameter /m/files/schemes: 'http'; accepted: a list of schemes, as [http, https]");
}

}  // namespace
}  // namespace collision_monitor::test
