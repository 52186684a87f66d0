// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace collision_monitor::pairs_tool {

/// Bytes [begin, end) of a text.
struct Span {
  std::size_t begin{0};
  std::size_t end{0};
};

/// A `<disable_collisions>` or `<enable_collisions>` element below the root.
struct SrdfLine {
  std::string link1, link2;  ///< as the monitor reads names: without leading space and slashes
  std::string reason;        ///< may be empty
  std::size_t number{0};     ///< of the line where it begins, from 1
  Span span;
};

/// The places in an SRDF that define which pairs are checked. Comments and CDATA count as text.
struct SrdfPlaces {
  std::string robot;     ///< the root's attribute name
  std::string encoding;  ///< as declared; empty: UTF-8
  std::vector<SrdfLine> disabled;
  std::vector<SrdfLine> enabled;
  std::vector<Span> parts;     ///< everything in the root except character data, in order
  std::size_t root_end{0};     ///< start of "</robot>", or of the "/>" of an empty root
  bool is_root_empty{false};   ///< "<robot name='r'/>"
  bool has_urdf_parts{false};  ///< a <link> or <joint> below the root
};

/// @throws std::runtime_error with line and reason if the text is no well-formed XML, or declares
/// entities, because their elements have no place in the text.
SrdfPlaces findPlaces(const std::string& srdf_xml);

}  // namespace collision_monitor::pairs_tool
