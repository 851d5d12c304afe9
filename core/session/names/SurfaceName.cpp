// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/SurfaceName.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfacePath.h"
#include "core/edits/kinds/surface/WriteBack.h"

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

/// What it did, and to how much of the surface.
QString withVertices(const QString& title, const EditStatistics& statistics)
{
    return title + QStringLiteral(", ")
        + (statistics.verticesChanged == 1
                ? QStringLiteral("1 vertex")
                : QStringLiteral("%1 vertices").arg(grouped(statistics.verticesChanged)));
}

/// "Sphere push 4.0 mm, 214 vertices"
QString strokeName(const char* verb, const SurfacePath& path, const EditStatistics& statistics)
{
    return withVertices(
        QLatin1String(verb) + QLatin1Char(' ') + millimetres(path.radiusMm), statistics);
}

} // namespace

QString surfaceName(
    const LaySurface& lay, const EditStatistics& statistics, const Document& document)
{
    return withVertices(
        QStringLiteral("Surface of %1").arg(quoted(segmentName(lay.segment, document))),
        statistics);
}

QString surfaceName(const DropSurface&, const EditStatistics&, const Document&)
{
    return QStringLiteral("Remove surface");
}

QString surfaceName(const FollowMask&, const EditStatistics& statistics, const Document&)
{
    return withVertices(QStringLiteral("Surface follows the mask"), statistics);
}

QString surfaceName(const MarkSurface& mark, const EditStatistics& statistics, const Document&)
{
    return withVertices(QStringLiteral("Mark %1, brush %2")
                            .arg(markWord(mark.mark), millimetres(mark.path.radiusMm)),
        statistics);
}

QString surfaceName(const ChangeMarks& change, const EditStatistics& statistics, const Document&)
{
    return withVertices(marksName(change), statistics);
}

QString surfaceName(const SpherePush& push, const EditStatistics& statistics, const Document&)
{
    return strokeName("Sphere push", push.path, statistics);
}

QString surfaceName(const PlaneScrape& scrape, const EditStatistics& statistics, const Document&)
{
    return strokeName("Scrape", scrape.path, statistics);
}

QString surfaceName(const PointDrag& drag, const EditStatistics& statistics, const Document&)
{
    return strokeName("Drag point", drag.path, statistics);
}

QString surfaceName(const ApplyTemplate& shape, const EditStatistics& statistics, const Document&)
{
    return withVertices(QStringLiteral("Template of %1")
                            .arg(counted(std::int64_t(shape.contoursLps.size()), "contour")),
        statistics);
}

QString surfaceName(const SmoothSurface& smooth, const EditStatistics& statistics, const Document&)
{
    return strokeName("Smooth surface", smooth.path, statistics);
}

QString surfaceName(
    const AttractSurface& attract, const EditStatistics& statistics, const Document&)
{
    return strokeName("Attract to edge", attract.path, statistics);
}

QString surfaceName(const WriteBack&, const EditStatistics& statistics, const Document& document)
{
    return QStringLiteral("Write surface back to %1, %2")
        .arg(
            quoted(document.surface ? segmentName(document.surface->segment, document) : QString()),
            counted(statistics.voxelsChanged, "voxel"));
}

} // namespace core
