// SPDX-License-Identifier: Apache-2.0
#include "core/volume/Volume.h"

#include <algorithm>

namespace core {

ProblemSentence::Argument slicesInWords(const std::vector<SliceSpan>& slices)
{
    std::vector<SliceSpan> joined;
    for (const SliceSpan& span : slices) {
        if (!joined.empty() && span.first <= joined.back().last + 1)
            joined.back().last = std::max(joined.back().last, span.last);
        else
            joined.push_back(span);
    }
    QStringList words;
    for (const SliceSpan& span : joined)
        words += span.first == span.last ? QString::number(span.first)
                                         : QStringLiteral("%1–%2").arg(span.first).arg(span.last);
    const bool one = joined.size() == 1 && joined.front().first == joined.front().last;
    return asPart({one ? ProblemCode::OneSlice : ProblemCode::Slices,
        {one ? words.front() : words.join(QLatin1String(", "))}});
}

bool Volume::needsCaution() const
{
    return std::any_of(problems.begin(), problems.end(),
        [](const VolumeProblem& problem) { return problem.caution; });
}

} // namespace core
