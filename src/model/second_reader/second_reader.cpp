// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/second_reader/second_reader.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <thread>

#include "model/second_reader/compare_readings.h"
#include "model/xml_declaration.h"

namespace collision_monitor {
namespace {

/// Suppresses urdfdom's log output in this thread: differences are reported elsewhere, and robots
/// that urdfdom refuses do not matter. Output of other threads passes through.
class Silence final : public console_bridge::OutputHandler {
 public:
  Silence() : before_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~Silence() override {
    if (console_bridge::getOutputHandler() == this) {
      console_bridge::useOutputHandler(before_);
    }
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* file,
           int line) override {
    if (std::this_thread::get_id() != thread_ && before_ != nullptr) {
      before_->log(text, level, file, line);
    }
  }

 private:
  console_bridge::OutputHandler* before_;
  std::thread::id thread_{std::this_thread::get_id()};
};

/// The largest number of attributes of an element. urdfdom's parser compares each with all earlier
/// ones.
std::ptrdiff_t mostAttributes(const std::string& xml) {
  std::ptrdiff_t most = 0;
  std::ptrdiff_t count = 0;
  for (const char c : xml) {
    count = c == '<' ? 0 : count + (c == '=' ? 1 : 0);
    most = std::max(most, count);
  }
  return most;
}

/// Whether the text is safe for urdfdom's parser, TinyXML 1. Our own reader has bounded the depth
/// before. Text beyond U+EFFF or invalid UTF-8 once caused an endless loop (CVE-2021-42260), a zero
/// byte an assertion (CVE-2023-34194).
bool isForParser(const std::string& xml) {
  constexpr std::size_t kMostBytes = 16'000'000;
  constexpr std::ptrdiff_t kMostAttributes = 1000;
  const auto is_unsafe = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0xEFU || (byte < 0x20U && c != '\t' && c != '\n' && c != '\r');
  };
  return xml.size() <= kMostBytes && std::none_of(xml.begin(), xml.end(), is_unsafe) &&
         mostAttributes(xml) <= kMostAttributes;
}

std::string withoutByteOrderMark(const std::string& xml) {
  return xml.compare(0, 3, "\xEF\xBB\xBF") == 0 ? xml.substr(3) : xml;
}

/// Null if urdfdom refuses the robot.
urdf::ModelInterfaceSharedPtr readByUrdfdom(const std::string& xml) {
  const Silence silence;
  try {
    return urdf::parseURDF(xml);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {  // any exception means that it cannot read the robot
    return nullptr;
  }
}

/// Unlinks the links. They own their children, so a long chain would be destroyed by recursion.
void takeApart(urdf::ModelInterface& model) {
  for (auto& [name, link] : model.links_) {
    link->child_links.clear();
    link->child_joints.clear();
  }
}

}  // namespace

std::vector<Problem> askSecondReader(const std::vector<RobotDescription>& robots,
                                     const RobotModel& model) {
  constexpr std::size_t kMostLinks = 2000;  // urdfdom destroys a robot that it refuses by recursion
  std::vector<Problem> differences;
  for (std::size_t i = 0; i < robots.size() && i < model.robots.size(); ++i) {
    const std::string xml = withoutLateDeclaration(withoutByteOrderMark(robots[i].urdf_xml));
    if (model.robots[i].link_count > kMostLinks || !isForParser(xml)) {
      continue;
    }
    if (const urdf::ModelInterfaceSharedPtr theirs = readByUrdfdom(xml)) {
      compareReadings(robots[i].source, model, idAt<RobotId>(i), *theirs, differences);
      takeApart(*theirs);
    }
  }
  return differences;
}

}  // namespace collision_monitor
