// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <termios.h>

namespace collision_monitor::two_capsules {

/// Single keys from the terminal that the program was started in, without Enter and unseen;
/// none where there is no terminal or it belongs to another program now. Ctrl-C stays what it is.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool isThere() const { return is_there_; }

  /// A key that was pressed, or 0; does not wait.
  char read() const;

 private:
  termios before_{};
  bool is_there_{false};
};

}  // namespace collision_monitor::two_capsules
