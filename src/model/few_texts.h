// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace collision_monitor {

/// Keeps the first few of many texts and counts the rest. A request may have a million faults; five
/// are enough to see what is wrong.
class FewTexts {
 public:
  /// @param make returns the text; not called for texts that are only counted
  template <class Make>
  void add(const Make& make) {
    constexpr std::size_t kShown = 5;
    if (texts_.size() == kShown) {
      ++more_;
      return;
    }
    std::string text = make();
    if (std::find(texts_.begin(), texts_.end(), text) == texts_.end()) {
      texts_.push_back(std::move(text));
    }
  }

  /// Each text once, then "999995 more" if there are more.
  std::vector<std::string> all() const {
    std::vector<std::string> texts = texts_;
    if (more_ > 0) {
      texts.push_back(std::to_string(more_) + " more");
    }
    return texts;
  }

 private:
  std::vector<std::string> texts_;
  std::size_t more_{0};
};

}  // namespace collision_monitor
