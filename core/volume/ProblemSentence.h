// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clauses.h"
#include "core/base/words/Said.h"

#include <QStringList>

#include <cstdint>
#include <vector>

namespace core {

/// A sentence about a problem of a volume, or a part of one. ProblemSentences.def lists all of them
/// with their English forms.
enum class ProblemCode : std::uint8_t {
#define PROBLEM_SENTENCE(code, ...) code,
#include "core/volume/ProblemSentences.def"
#undef PROBLEM_SENTENCE
};

/// A code with its arguments, such as the number of missing slices. ui/texts/ProblemTexts.h puts it
/// into words.
using ProblemSentence = Said<ProblemCode>;

/// Inserts parts of a sentence as one argument, separated by commas: "two slices are missing, their
/// distances are uneven".
[[nodiscard]] ProblemSentence::Argument withCommas(std::vector<ProblemSentence> parts);
/// Inserts names as one argument, with the separator @p joiner between them.
[[nodiscard]] ProblemSentence::Argument namesIn(
    const Clauses& names, ProblemCode joiner = ProblemCode::Comma);
/// Inserts a sentence as an argument of another one.
[[nodiscard]] ProblemSentence::Argument asPart(ProblemSentence sentence);

/// The English text that session files store. It must never change.
[[nodiscard]] QString storedText(const ProblemSentence& sentence);

} // namespace core
