// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/ApplyEdits.h"

#include "core/edits/answers/ListEdits.h"
#include "core/edits/kinds/chunks/Chunks.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"

namespace core::applyEdits {

Result<bool> changeSurface(Document& document, bool deforms)
{
    if (!document.surface)
        return failure(ErrorCode::InvalidField, QStringLiteral("surface"),
            QStringLiteral("there is none; lay one around a segment first"));
    document.surface->differs |= deforms;
    return true;
}

Result<bool> apply(const LaySurface& edit, Document& document)
{
    if (!document.segment(edit.segment))
        return unknownSegment(edit.segment);
    constexpr int fewest = 100;
    if (edit.vertices != 0 && edit.vertices < fewest)
        return failure(ErrorCode::InvalidField, QStringLiteral("surface.vertices"),
            QStringLiteral("%1 are too few: %2 at least, or 0 for as many as it takes")
                .arg(edit.vertices)
                .arg(fewest));
    document.surface = {.segment = edit.segment, .differs = false};
    return true;
}

Result<bool> apply(const DropSurface&, Document& document)
{
    const Result<bool> known = changeSurface(document, false);
    document.surface.reset();
    return known;
}

Result<bool> apply(const MarkSurface&, Document& document)
{
    return changeSurface(document, false);
}

Result<bool> apply(const ChangeMarks& edit, Document& document)
{
    if (edit.mark == SurfaceMark::Yellow)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.mark"),
            QStringLiteral("yellow is what is not marked"));
    using Way = ChangeMarks::Way;
    if (edit.way == Way::Accept && edit.mark != SurfaceMark::Red)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.mark"),
            QStringLiteral("only what is red can be accepted"));
    if (edit.nearLps && edit.way != Way::Clear && edit.way != Way::Accept)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.nearLps"),
            QStringLiteral("goes with clear and accept"));
    return changeSurface(document, false);
}

Result<bool> apply(const PlaneScrape& edit, Document& document)
{
    if (edit.normalLps == glm::dvec3(0.0))
        return failure(ErrorCode::InvalidField, QStringLiteral("planeScrape.normalLps"),
            QStringLiteral("has no direction"));
    return changeSurface(document, true);
}

Result<bool> apply(const WriteBack&, Document& document)
{
    if (const Result<bool> known = changeSurface(document, false); !known)
        return known;
    const Segment* segment = document.segment(document.surface->segment);
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);
    document.surface->differs = false;
    document.surface->maskChanged = false;
    return true;
}

Result<bool> apply(const SurfaceBarrier&, Document& document)
{
    const Result<bool> known = changeSurface(document, false);
    return known ? Result<bool>(false) : known;
}

/// Whether it divides otherwise than before only the session can tell, who has the rows.
Result<bool> apply(const Chunks& edit, Document& document)
{
    if (!document.segment(edit.segment))
        return unknownSegment(edit.segment);
    document.chunks = {
        .id = document.lastChunksGiven() + 1, .segment = edit.segment, .marginMm = edit.marginMm};
    return true;
}

} // namespace core::applyEdits
