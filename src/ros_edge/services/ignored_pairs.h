// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/LinkDistance.h>

#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"

/// Pairs that are not checked, for those who ask for them.
namespace collision_monitor {

using LinkSet = std::vector<unsigned char>;  ///< by LinkId

/// The link pairs of two sets.
struct Selection {
  LinkSet a;
  LinkSet b;

  bool has(LinkId one, LinkId other) const {
    return (a[index(one)] != 0 && b[index(other)] != 0) ||
           (a[index(other)] != 0 && b[index(one)] != 0);
  }
};

/// Why selected pairs are ignored; empty if none is. Two objects that form no pair are not named.
std::string ignoredText(const CycleSetup& setup, const Selection& selection);

/// All selected pairs, checked or not; those of two objects that form no pair, too.
/// @param fault not empty if there are too many of the latter
std::vector<LinkPair> pairsOf(const CycleSetup& setup, const Selection& selection,
                              std::string& fault);

/// Why each of these pairs is checked or not, and where the rule stands that says so.
std::vector<std::string> reasonsOf(const CycleSetup& setup, const std::vector<LinkDistance>& pairs);

}  // namespace collision_monitor
