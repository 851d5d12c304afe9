// SPDX-License-Identifier: Apache-2.0
#include "core/titles/ReportSentence.h"

#include <utility>

namespace core {

ReportSentence::Argument inReport(std::vector<ReportSentence> parts)
{
    return ReportSentence::Listed{.joiner = ReportCode::Comma, .all = std::move(parts)};
}

ReportSentence::Argument inReport(ReportSentence part)
{
    return inReport(std::vector<ReportSentence>{std::move(part)});
}

ReportSentence::Argument namesInReport(const QStringList& names)
{
    ReportSentence::Listed listed{.joiner = ReportCode::Comma};
    for (const QString& name : names)
        listed.all.push_back({ReportCode::Joined, {name}});
    return listed;
}

ReportSentence::Argument countedInReport(ReportCode noun, std::int64_t count)
{
    return inReport(ReportSentence{noun, {count}});
}

} // namespace core
