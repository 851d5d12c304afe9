// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"

namespace core {

using namespace rowWords;

Result<bool> changeSurface(Document& document, bool deforms)
{
    if (!document.surface)
        return failure(ErrorCode::InvalidField, QStringLiteral("surface"),
            Clause::saying("there is none; lay one around a segment first"));
    document.surface->differs |= deforms;
    return true;
}

Result<void> checkPressures(const SurfacePath& path, const char* name)
{
    return checkPressures(path.pressures, path.pointsLps.size(), QString::fromLatin1(name));
}

EditEffects surfaceEffects(Opening standsOpen)
{
    return {.task = EditTask::Surface,
        .standsOpen = standsOpen,
        .changes = DocumentChange::What::Surface,
        .onlyDocument = true,
        .fills = fillsNothing,
        .boundToStudy = bool(standsOpen)};
}

RowTitle markTitle(SurfaceMark mark)
{
    switch (mark) {
    case SurfaceMark::Green:
        return {.code = RowTitleCode::Green};
    case SurfaceMark::Red:
        return {.code = RowTitleCode::Red};
    case SurfaceMark::Yellow:
        break;
    }
    return {.code = RowTitleCode::Yellow};
}

RowTitle strokeTitle(RowTitleCode code, const SurfacePath& path, const EditStatistics& statistics)
{
    return {.code = code,
        .arguments = {inMm(path.radiusMm)},
        .then = {figure(RowTitleCode::Vertices, statistics.verticesChanged)}};
}

} // namespace core
