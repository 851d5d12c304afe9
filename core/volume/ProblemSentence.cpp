// SPDX-License-Identifier: Apache-2.0
#include "core/volume/ProblemSentence.h"

#include <array>
#include <utility>

namespace core {

namespace {

struct ProblemForm {
    const char* text;
    const char* one = nullptr;
};

constexpr std::array problemForms{
#define PROBLEM_SENTENCE(code, ...) ProblemForm{__VA_ARGS__},
#include "core/volume/ProblemSentences.def"
#undef PROBLEM_SENTENCE
};

/// Of session files.
class StoredEnglish : public SaidLanguage<ProblemCode> {
public:
    [[nodiscard]] QString form(ProblemCode code, std::int64_t count) const override
    {
        const ProblemForm& known = problemForms[std::size_t(code)];
        return QString::fromUtf8(known.one && count == 1 ? known.one : known.text);
    }
};

} // namespace

ProblemSentence::Argument withCommas(std::vector<ProblemSentence> parts)
{
    return ProblemSentence::Listed{.joiner = ProblemCode::Comma, .all = std::move(parts)};
}

ProblemSentence::Argument namesIn(const Clauses& names, ProblemCode joiner)
{
    ProblemSentence::Listed listed{.joiner = joiner};
    for (const Clause& name : names)
        listed.all.push_back({ProblemCode::AsStored, {name}});
    return listed;
}

ProblemSentence::Argument asPart(ProblemSentence sentence)
{
    return withCommas({std::move(sentence)});
}

QString storedText(const ProblemSentence& sentence)
{
    return worded(sentence, StoredEnglish());
}

} // namespace core
