// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clauses.h"
#include "core/base/words/Said.h"

#include <QStringList>

#include <cstdint>
#include <vector>

namespace core {

/// What is said of a problem of a volume, or a part of that: ProblemSentences.def lists them.
enum class ProblemCode : std::uint8_t {
#define PROBLEM_SENTENCE(code, ...) code,
#include "core/volume/ProblemSentences.def"
#undef PROBLEM_SENTENCE
};

/// One sentence about a problem; ui/texts/ProblemTexts.h words it.
using ProblemSentence = Said<ProblemCode>;

/// Several parts of a sentence, with commas.
[[nodiscard]] ProblemSentence::Argument withCommas(std::vector<ProblemSentence> parts);
/// Names, with what stands between two of them.
[[nodiscard]] ProblemSentence::Argument namesIn(
    const Clauses& names, ProblemCode joiner = ProblemCode::Comma);
/// A sentence in another one.
[[nodiscard]] ProblemSentence::Argument asPart(ProblemSentence sentence);

/// The English that session files keep. It never changes.
[[nodiscard]] QString storedText(const ProblemSentence& sentence);

} // namespace core
