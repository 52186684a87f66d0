// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/urdf_text.h"

#include <stdexcept>

namespace collision_monitor::test {
namespace {

std::vector<std::string> sentences(const std::vector<Problem>& problems) {
  std::vector<std::string> texts;
  texts.reserve(problems.size());
  for (const Problem& problem : problems) {
    texts.push_back(toString(problem));
  }
  return texts;
}

}  // namespace

std::vector<std::string> ReadText::errors() const { return sentences(report.errors); }

std::vector<std::string> ReadText::warnings() const { return sentences(report.warnings); }

std::string robotXml(const std::string& elements) {
  return "<robot name='r'>\n" + elements + "\n</robot>";
}

std::string linkXml(const std::string& name, const std::string& geometry,
                    const std::string& origin) {
  return "<link name='" + name + "'><collision>" + origin + "<geometry>" + geometry +
         "</geometry></collision></link>";
}

std::string jointXml(const std::string& name, const std::string& type, const std::string& parent,
                     const std::string& child, const std::string& rest) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + rest + "</joint>";
}

RobotDescription describeText(const std::string& xml) {
  RobotDescription description;
  description.source = "test.urdf";
  description.urdf_xml = xml;
  return description;
}

ResourceLoader textLoader(const std::map<std::string, std::string>& files) {
  return [files](const std::string& uri) {
    const auto found = files.find(uri);
    if (found == files.end()) {
      throw std::runtime_error("no file " + uri);
    }
    return found->second;
  };
}

ReadText readText(const std::string& xml, const std::map<std::string, std::string>& files) {
  ReadText read;
  read.model = readRobots({describeText(xml)}, textLoader(files), read.report);
  return read;
}

}  // namespace collision_monitor::test
