// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/ply_check.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "model/mesh_files/mesh_reader.h"

namespace collision_monitor {
namespace {

/// Three vertices and a triangle.
std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar ushort vertex_indices\nend_header\n";
}

template <class Number>
std::string encoded(Number number, bool is_big_endian) {
  std::string bytes(sizeof(number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(number));
  return is_big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string binaryPly(bool is_big_endian) {
  std::string bytes = plyHeader(is_big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const float number : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F}) {
    bytes += encoded(number, is_big_endian);
  }
  bytes += '\3';
  for (std::uint16_t corner = 0; corner < 3; ++corner) {
    bytes += encoded(corner, is_big_endian);
  }
  return bytes;
}

std::string plyFaultOf(const std::string& bytes) {
  try {
    checkPlyIsComplete(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlyCheck, wholeFiles_areRead) {
  for (const std::string& bytes : {binaryPly(false), binaryPly(true), binaryPly(false) + "more",
                                   plyHeader("ascii") + "0 0 0\n\n1 0 0\r\n0 2 0\n3 0 1 2"}) {
    EXPECT_EQ(plyFaultOf(bytes), "no error");
    EXPECT_EQ(readMesh(bytes, "a.ply").triangles.size(), 1U);
  }
}

TEST(PlyCheck, binaryCutShort_isAnErrorWhereverItIsCut) {
  for (const bool is_big_endian : {false, true}) {
    const std::string bytes = binaryPly(is_big_endian);
    for (std::size_t cut = 1; cut <= 43; ++cut) {
      EXPECT_EQ(plyFaultOf(bytes.substr(0, bytes.size() - cut)),
                "the binary PLY is cut short: it announces 4 elements, more than " +
                    std::to_string(43 - cut) + " bytes hold");
    }
  }
}

TEST(PlyCheck, lineThatLacksNumbers_isAnError) {
  EXPECT_EQ(plyFaultOf(plyHeader("ascii") + "0 0 0\n1 0\n0 2 0\n3 0 1 2\n"),
            "line 11 has fewer numbers than the PLY header announces");
  EXPECT_EQ(plyFaultOf(plyHeader("ascii") + "0 0 0\n1 0 0\n0 2 0\n3 0 1\n"),
            "line 13 has fewer numbers than the PLY header announces");
  EXPECT_EQ(plyFaultOf(plyHeader("ascii") + "0 0 0\n1 0 0\n0 2 0\n-3 0 1 2\n"),
            "line 13 has fewer numbers than the PLY header announces");
}

TEST(PlyCheck, headerOfNoSense_isAnError) {
  EXPECT_EQ(plyFaultOf("ply\nformat ascii 1.0\nproperty float x\nend_header\n"),
            "the PLY header has a property before its first element");
  EXPECT_EQ(plyFaultOf("ply\nformat ascii 1.0\nelement vertex 0\nproperty half x\nend_header\n"),
            "the PLY header has a property of unknown type 'half'");
}

}  // namespace
}  // namespace collision_monitor
