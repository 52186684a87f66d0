// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/world_parameters.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>

#include "model/number_text.h"
#include "model/world/world_text.h"

namespace collision_monitor {
namespace {

using XmlRpc::XmlRpcValue;

/// In double quotes, with the escapes of JSON, which is YAML.
std::string escaped(const std::string& text) {
  std::string yaml = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      yaml += '\\';
      yaml += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof(code), "\\u%04x", static_cast<unsigned>(c));
      yaml += code;
    } else {
      yaml += c;
    }
  }
  return yaml + "\"";
}

std::string directoryOf(const std::string& uri) {
  const std::size_t slash = uri.rfind('/');
  return slash == std::string::npos ? "" : uri.substr(0, slash);
}

}  // namespace

std::string yamlOf(const XmlRpcValue& value) {
  std::string text;
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      return escaped(static_cast<std::string>(value));
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return shortText(static_cast<double>(value));
    case XmlRpcValue::TypeArray:
      for (int i = 0; i < value.size(); ++i) {
        text += (i == 0 ? "" : ", ") + yamlOf(value[i]);
      }
      return "[" + text + "]";
    case XmlRpcValue::TypeStruct:
      for (const auto& [name, field] : value) {
        text += (text.empty() ? "" : ", ") + escaped(name) + ": " + yamlOf(field);
      }
      return "{" + text + "}";
    default:
      return "null";
  }
}

std::vector<WorldObject> loadObjects(const Parameters& parameters,
                                     const ResourceLoader& load_resource, SetupReport& report) {
  const MeshReading& reading = parameters.setup.meshes;
  std::vector<WorldObject> objects;
  if (!parameters.world.empty()) {
    objects = readWorld({parameters.setup.where + "world", parameters.world, ""}, load_resource,
                        reading, report);
    for (WorldObject& object : objects) {
      object.where = parameters.setup.where + "world";  // its lines are not the user's
    }
  }
  const std::string& file = parameters.world_file;
  if (file.empty()) {
    return objects;
  }
  try {
    const DocumentText text{file, load_resource(file), directoryOf(file)};
    std::vector<WorldObject> of_file = readWorld(text, load_resource, reading, report);
    if (of_file.empty() && report.errors.empty()) {
      report.warnings.push_back({file, "no object", "", "nothing is watched beside the robots"});
    }
    std::move(of_file.begin(), of_file.end(), std::back_inserter(objects));
  } catch (const std::exception& fault) {
    report.errors.push_back({parameters.setup.where + "world_file '" + file + "'", fault.what(),
                             "a readable file or package:// URI"});
    report.awaits_names = true;
  }
  return objects;
}

void checkFrames(const std::vector<WorldObject>& objects, const ListedRobot& first,
                 const std::string& world_frame, SetupReport& report) {
  if (first.id || !world_frame.empty()) {
    return;
  }
  for (const WorldObject& object : objects) {
    if (!object.is_attached && object.frame.empty()) {
      report.errors.push_back(
          {(object.where.empty() ? "world" : object.where) + ", object '" + object.name + "'",
           "no frame, while the root link of robot '" + first.name +
               "' is not known: " + first.missing,
           "the name of a frame, or one in the parameter world_frame"});
    }
  }
}

}  // namespace collision_monitor
