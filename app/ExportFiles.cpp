// SPDX-License-Identifier: Apache-2.0
#include "app/ExportFiles.h"

#include "app/JsonLine.h"
#include "core/export/ExportChoices.h"

namespace app {

using core::Result;

Result<void> exportFiles(
    const std::vector<core::RecipeExport>& targets, core::EditSession& session, bool force)
{
    if (targets.empty())
        return {};
    const Result<std::vector<std::uint8_t>> labels = session.labels(0);
    if (!labels)
        return tl::unexpected(labels.error());
    core::ExportRequest request;
    request.force = force;
    request.planes = {{.plane = 0, .labels = *labels}};
    for (const core::ExportChoice& choice : core::exportChoices(session.document(), {})) {
        if (choice.chosen)
            request.segments.push_back(choice.segment);
    }
    for (const core::RecipeExport& target : targets) {
        request.format = target.format;
        request.file = target.file;
        const Result<core::ExportReport> report =
            core::exportMask(session.document().volumes.front(), request, core::Progress());
        if (!report)
            return tl::unexpected(report.error());
        const auto list = [](const QStringList& sentences) {
            return QJsonValue(sentences.join(QStringLiteral(" ")));
        };
        printJsonLine({
            {QStringLiteral("export"), report->file},
            {QStringLiteral("written"), list(report->written)},
            {QStringLiteral("checked"), list(report->checked)},
            {QStringLiteral("cautions"), list(report->cautions)},
        });
    }
    return {};
}

} // namespace app
