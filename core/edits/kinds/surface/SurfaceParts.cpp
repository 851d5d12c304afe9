// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/SurfaceParts.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/surface/SurfacePath.h"

namespace core {

using namespace rowWords;

Result<bool> changeSurface(Document& document, bool deforms)
{
    if (!document.surface)
        return failure(ErrorCode::InvalidField, QStringLiteral("surface"),
            QStringLiteral("there is none; lay one around a segment first"));
    document.surface->differs |= deforms;
    return true;
}

EditEffects surfaceEffects(bool standsOpen)
{
    return {.task = EditTask::Surface,
        .standsOpen = standsOpen,
        .changes = DocumentChange::What::Surface,
        .onlyDocument = true,
        .boundToStudy = standsOpen};
}

QString markWord(SurfaceMark mark)
{
    switch (mark) {
    case SurfaceMark::Green:
        return QStringLiteral("green");
    case SurfaceMark::Red:
        return QStringLiteral("red");
    case SurfaceMark::Yellow:
        break;
    }
    return QStringLiteral("yellow");
}

QString withVertices(const QString& title, const EditStatistics& statistics)
{
    return title + QStringLiteral(", ")
        + (statistics.verticesChanged == 1
                ? QStringLiteral("1 vertex")
                : QStringLiteral("%1 vertices").arg(grouped(statistics.verticesChanged)));
}

QString strokeName(const char* verb, const SurfacePath& path, const EditStatistics& statistics)
{
    return withVertices(
        QLatin1String(verb) + QLatin1Char(' ') + millimetres(path.radiusMm), statistics);
}

} // namespace core
