// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace collision_monitor {

/// A program's answer to one question. Throws std::exception with a sentence if there is none.
using AnswerQuestion =
    std::function<std::string(const std::string& name, const std::string& bytes)>;

/// The text for a question that needs more memory than its limit [bytes].
using TellMemoryFault = std::function<std::string(const std::string& bytes, std::uint64_t limit)>;

/// The helper's side of HelperProcess, and all that its main() calls. Answers questions one by one
/// from the socket on standard input, until the socket is closed.
///
/// Ends with the process that started it, keeps none of its files open, dumps no core, is the first
/// to be killed when the machine runs out of memory, and ignores Ctrl-C. Each question carries its
/// limits of memory and processor time. Running out of memory is reported as such, even if the
/// libraries that answer ignore it.
/// @param memory_fault text of that report; the name precedes it
/// @return exit code
int answerQuestions(const AnswerQuestion& answer, const TellMemoryFault& memory_fault);

}  // namespace collision_monitor
