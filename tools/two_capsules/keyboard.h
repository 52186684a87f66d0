// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <termios.h>

namespace collision_monitor::two_capsules {

/// Reads single keys from the terminal where the program was started, without Enter or echo. No
/// keys if there is no terminal, or another program owns it now. Ctrl-C works as usual.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool isThere() const { return is_there_; }

  /// A key that was pressed, or 0; does not block.
  char read() const;

 private:
  termios before_{};
  bool is_there_{false};
};

}  // namespace collision_monitor::two_capsules
