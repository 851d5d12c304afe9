// SPDX-License-Identifier: Apache-2.0
#include "core/session/SurfaceName.h"

#include "core/session/RowWords.h"

namespace core {

using namespace rowWords;

namespace {

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

QString marksName(const ChangeMarks& change)
{
    const QString word = markWord(change.mark);
    const QString what = change.nearLps ? QStringLiteral("region") : QStringLiteral("marks");
    switch (change.way) {
    case ChangeMarks::Way::Grow:
        return QStringLiteral("Grow %1 marks").arg(word);
    case ChangeMarks::Way::Shrink:
        return QStringLiteral("Shrink %1 marks").arg(word);
    case ChangeMarks::Way::Invert:
        return QStringLiteral("Invert %1 marks").arg(word);
    case ChangeMarks::Way::Accept:
        return QStringLiteral("Sign off %1 %2").arg(word, what);
    case ChangeMarks::Way::Clear:
        break;
    }
    return QStringLiteral("Clear %1 %2").arg(word, what);
}

/// What it does, without the figures at its end.
QString titleOf(const Edit& edit, const Document& document)
{
    if (const auto* lay = std::get_if<LaySurface>(&edit))
        return QStringLiteral("Surface of %1").arg(quoted(segmentName(lay->segment, document)));
    if (std::holds_alternative<FollowMask>(edit))
        return QStringLiteral("Surface follows the mask");
    if (const auto* mark = std::get_if<MarkSurface>(&edit))
        return QStringLiteral("Mark %1, brush %2")
            .arg(markWord(mark->mark), millimetres(mark->path.radiusMm));
    if (const auto* change = std::get_if<ChangeMarks>(&edit))
        return marksName(*change);
    if (const auto* push = std::get_if<SpherePush>(&edit))
        return QStringLiteral("Sphere push %1").arg(millimetres(push->path.radiusMm));
    if (const auto* scrape = std::get_if<PlaneScrape>(&edit))
        return QStringLiteral("Scrape %1").arg(millimetres(scrape->path.radiusMm));
    if (const auto* drag = std::get_if<PointDrag>(&edit))
        return QStringLiteral("Drag point %1").arg(millimetres(drag->path.radiusMm));
    if (const auto* shape = std::get_if<ApplyTemplate>(&edit))
        return QStringLiteral("Template of %1")
            .arg(counted(std::int64_t(shape->contoursLps.size()), "contour"));
    if (const auto* smooth = std::get_if<SmoothSurface>(&edit))
        return QStringLiteral("Smooth surface %1").arg(millimetres(smooth->path.radiusMm));
    if (const auto* attract = std::get_if<AttractSurface>(&edit))
        return QStringLiteral("Attract to edge %1").arg(millimetres(attract->path.radiusMm));
    return {};
}

} // namespace

QString surfaceRowName(const Edit& edit, const EditStatistics& statistics, const Document& document)
{
    if (std::holds_alternative<DropSurface>(edit))
        return QStringLiteral("Remove surface");
    if (std::holds_alternative<WriteBack>(edit))
        return QStringLiteral("Write surface back to %1, %2")
            .arg(quoted(document.surface ? segmentName(document.surface->segment, document)
                                         : QString()),
                counted(statistics.voxelsChanged, "voxel"));
    const QString title = titleOf(edit, document);
    if (title.isEmpty())
        return title;
    return title + QStringLiteral(", ")
        + (statistics.verticesChanged == 1
                ? QStringLiteral("1 vertex")
                : QStringLiteral("%1 vertices").arg(grouped(statistics.verticesChanged)));
}

} // namespace core
