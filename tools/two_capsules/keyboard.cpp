// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "keyboard.h"

#include <unistd.h>

namespace collision_monitor::two_capsules {
namespace {

/// A background program that uses its terminal is stopped. roslaunch gives its nodes a terminal of
/// its own, which has no owner to ask for.
bool ownsTerminal() {
  const pid_t owner = tcgetpgrp(STDIN_FILENO);
  return owner < 0 ? isatty(STDIN_FILENO) == 1 : owner == getpgrp();
}

}  // namespace

Keyboard::Keyboard() {
  if (!ownsTerminal() || tcgetattr(STDIN_FILENO, &before_) != 0) {
    return;
  }
  termios raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  is_there_ = tcsetattr(STDIN_FILENO, TCSANOW, &raw) == 0;
}

Keyboard::~Keyboard() {
  if (is_there_ && ownsTerminal()) {
    tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
}

char Keyboard::read() const {
  char key = 0;
  return is_there_ && ownsTerminal() && ::read(STDIN_FILENO, &key, 1) == 1 ? key : '\0';
}

}  // namespace collision_monitor::two_capsules
