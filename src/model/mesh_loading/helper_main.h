// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace collision_monitor {

/// A program's answer to one question; throws std::exception with a sentence where there is none.
using AnswerQuestion =
    std::function<std::string(const std::string& name, const std::string& bytes)>;

/// What is said of a question that needs more memory than its limit [bytes].
using TellMemoryFault = std::function<std::string(const std::string& bytes, std::uint64_t limit)>;

/// The other side of HelperProcess: the whole of such a program's main. Answers one question after
/// the other from the socket that is its standard input, until that is closed.
///
/// Ends with the process that started it. Holds no file of it, dumps no core, is the first to go
/// when the machine has no memory left, and leaves Ctrl-C to the other side. Each question has the
/// limits of memory and processor time that it comes with; to need more memory is an answer of its
/// own, also where the libraries that answer take no note of it.
/// @param memory_fault that answer, to stand behind the name
/// @return exit code
int answerQuestions(const AnswerQuestion& answer, const TellMemoryFault& memory_fault);

}  // namespace collision_monitor
