// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "merge_srdf.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision_monitor/model/srdf_reader.h"
#include "edit_srdf.h"
#include "model/xml_declaration.h"
#include "srdf_places.h"

namespace collision_monitor::pairs_tool {
namespace {

using NamePair = std::pair<std::string, std::string>;

NamePair ordered(const std::string& a, const std::string& b) {
  return a < b ? NamePair(a, b) : NamePair(b, a);
}

/// "line 12, 'arm' - 'hand' (Never)"
std::string placeText(const SrdfLine& line) {
  return "line " + std::to_string(line.number) + ", '" + line.link1 + "' - '" + line.link2 + "'" +
         (line.reason.empty() ? "" : " (" + line.reason + ")");
}

bool isOfStates(const std::string& reason) { return reason == "Never" || reason == "Always"; }

bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Names are in UTF-8, as in the URDF.
void checkEncoding(const std::string& encoding, const std::vector<PairLine>& lines) {
  std::string name = encoding;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.empty() || name == "utf-8") {
    return;
  }
  for (const PairLine& line : lines) {
    if (!isAscii(line.link1 + line.link2)) {
      throw std::runtime_error("the SRDF is in " + encoding + ", which cannot take '" + line.link1 +
                               "' - '" + line.link2 + "' as they are; make it UTF-8");
    }
  }
}

/// Lines that the file lacks and does not contradict.
std::vector<PairLine> missingLines(const SrdfPlaces& places, const std::vector<PairLine>& lines) {
  std::set<NamePair> named;
  for (const std::vector<SrdfLine>* present : {&places.disabled, &places.enabled}) {
    for (const SrdfLine& line : *present) {
      named.insert(ordered(line.link1, line.link2));
    }
  }
  std::vector<PairLine> missing;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(missing), [&](const PairLine& line) {
    return named.count(ordered(line.link1, line.link2)) == 0;
  });
  return missing;
}

}  // namespace

std::string robotNameOf(const std::string& urdf_xml) {
  tinyxml2::XMLDocument document;
  const std::string xml = withoutLateDeclaration(urdf_xml);
  const bool is_read = document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS &&
                       document.RootElement() != nullptr;
  const char* name = is_read ? document.RootElement()->Attribute("name") : nullptr;
  return name == nullptr ? "" : name;
}

void checkMergeable(const std::string& path, const std::string& srdf_xml,
                    const std::string& robot_name, const std::string& option, SetupReport& report) {
  const std::size_t errors_before = report.errors.size();
  RobotDescription description;
  description.source = path;
  description.srdf_xml = srdf_xml;
  readSrdf(description, RobotId{0}, RobotModel(), report);  // reads it as the monitor does
  if (report.errors.size() > errors_before) {
    return;
  }
  const auto refuse = [&](const std::string& found) {
    const char* const other =
        option == "--check" ? "'" : "', a new file, or --force to replace the file as a whole";
    report.errors.push_back({"option " + option + ", '" + path + "'", found,
                             "an SRDF of robot '" + robot_name + other});
  };
  try {
    const SrdfPlaces places = findPlaces(srdf_xml);
    if (places.has_urdf_parts) {
      refuse("<link> or <joint>, as in a URDF");
    } else if (!robot_name.empty() && places.robot != robot_name) {
      refuse("robot name '" + places.robot + "'");
    }
  } catch (const std::runtime_error& fault) {
    refuse(std::string("XML that cannot be merged into, ") + fault.what());
  }
}

SrdfMerge mergeSrdf(const std::string& srdf_xml, const RobotModel& model,
                    const std::vector<PairFound>& pairs, const PairLines& lines) {
  std::map<NamePair, const PairFound*> seen;
  for (const PairFound& pair : pairs) {
    seen[ordered(model.link(pair.a).name, model.link(pair.b).name)] = &pair;
  }
  const SrdfPlaces places = findPlaces(srdf_xml);
  SrdfMerge merge;
  std::vector<SrdfLine> refuted;
  for (const SrdfLine& line : places.disabled) {
    const auto found = seen.find(ordered(line.link1, line.link2));
    const bool touches = found != seen.end() && found->second->finding == PairFinding::sometimes;
    if (touches && isOfStates(line.reason)) {
      merge.taken_out.push_back(placeText(line) + ": they touch " +
                                stateText(model, *found->second) +
                                " and are apart in other states");
      refuted.push_back(line);
    } else {
      ++merge.kept;
      if (touches) {
        merge.doubted.push_back(placeText(line));
      }
    }
  }
  const std::vector<PairLine> missing = missingLines(places, lines.lines);
  checkEncoding(places.encoding, missing);
  merge.added = missing.size();
  merge.left_out = missingLines(places, lines.left_out).size();
  merge.text = editSrdf(srdf_xml, places, refuted, missing);
  return merge;
}

}  // namespace collision_monitor::pairs_tool
