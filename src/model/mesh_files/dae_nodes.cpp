// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <stdexcept>

#include "model/mesh_files/dae_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

/// Computes how deep nodes nest. Visits each node once.
class NodeHeights {
 public:
  explicit NodeHeights(const tinyxml2::XMLDocument& document) {
    // assimp prefers the id.
    for (const char* name : {"id", "sid"}) {
      forElements("node", document, [&](const XMLElement& node) {
        if (node.Attribute(name) != nullptr) {
          node_of_.emplace(node.Attribute(name), &node);
        }
      });
    }
  }

  /// @param depth levels below the node where the search began
  /// @return number of levels from this node down, including its own
  int heightOf(const XMLElement& node, int depth) {
    const auto [known, is_new] = height_of_.emplace(&node, kUnderway);
    if (known->second == kUnderway && !is_new) {
      refuseElement(node, "instances itself");
    }
    if (is_new) {
      const int below = heightBelow(node, depth + 1);  // may add to the map
      height_of_[&node] = 1 + below;
    }
    const int height = height_of_[&node];
    checkDepth(node, depth + height);
    return height;
  }

 private:
  static constexpr int kUnderway = 0;
  static constexpr int kDeepestNode = 500;  // usual files have ten or twenty

  static void checkDepth(const XMLElement& node, int depth) {
    if (depth > kDeepestNode) {
      refuseElement(node, "nests deeper than " + std::to_string(kDeepestNode) + " nodes");
    }
  }

  int heightBelow(const XMLElement& node, int depth) {
    checkDepth(node, depth);
    int height = 0;
    for (const XMLElement* e = node.FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      const std::string_view name = e->Name();
      if (name == "node") {
        height = std::max(height, heightOf(*e, depth));
      } else if (name == "instance_node") {
        const std::string url = attributeOf(*e, "url");
        const auto found = node_of_.find(url.substr(std::min<std::size_t>(1, url.size())));
        height = std::max(height, found == node_of_.end() ? 0 : heightOf(*found->second, depth));
      }
    }
    return height;
  }

  std::map<std::string, const XMLElement*> node_of_;  ///< by id or sid
  std::map<const XMLElement*, int> height_of_;
};

}  // namespace

void refuseElement(const XMLElement& element, const std::string& fault) {
  throw std::runtime_error("line " + std::to_string(element.GetLineNum()) + ": <" + element.Name() +
                           "> " + fault);
}

void checkDaeNodes(const tinyxml2::XMLDocument& document) {
  NodeHeights heights(document);
  forElements("node", document, [&](const XMLElement& node) { heights.heightOf(node, 0); });
}

}  // namespace collision_monitor
