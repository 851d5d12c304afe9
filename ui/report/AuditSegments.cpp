// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditSegments.h"

#include "core/brick/LabelRuns.h"
#include "core/measure/MeasuredSize.h"
#include "ui/report/ChangePicture.h"

#include <QBuffer>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

QByteArray pngOf(const QImage& image)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

/// The slice with the most changes since the import; empty without any.
void addPicture(
    AuditSegments::One& one, const core::Volume& volume, const core::ExportRequest& request)
{
    const core::Segment& segment = one.measured.segment;
    const auto imported = std::find_if(request.imported.begin(), request.imported.end(),
        [&](const core::ImportedVoxels& each) { return each.label == segment.label; });
    if (imported == request.imported.end())
        return;
    const core::VoxelRuns now =
        core::labelRuns(core::planeOf(request, segment)->labels, segment.label);
    if (const auto picture = changePicture(volume, request.codes, now, imported->voxels)) {
        one.changes = pngOf(picture->image);
        one.slice = picture->slice;
    }
}

} // namespace

core::Result<AuditSegments> auditSegments(
    const core::Volume& volume, const core::ExportRequest& request, const core::Progress& progress)
{
    core::Result<core::MaskSelection> selection = core::selectMask(volume, request);
    if (!selection) {
        if (selection.error().code != core::ErrorCode::NothingToExport)
            return tl::unexpected(selection.error());
        selection = core::MaskSelection{};
    }
    auto measured = core::segmentStatistics(volume, request, *selection, progress);
    if (!measured)
        return tl::unexpected(measured.error());
    // What was erased completely was changed, too.
    for (const core::Segment& segment : request.segments) {
        if (std::any_of(selection->segments.begin(), selection->segments.end(),
                [&](const core::Segment& each) { return each.label == segment.label; }))
            continue;
        core::SegmentStatistics& none = measured->emplace_back();
        none.segment = segment;
        none.sinceImport =
            core::changeSinceImport({}, segment.label, request.imported, volume.geometry);
    }
    AuditSegments found;
    found.areCounted = core::unknownSpacing(volume) != core::UnknownSpacing::Nothing;
    for (core::SegmentStatistics& each : *measured) {
        AuditSegments::One one{.measured = std::move(each), .changes = {}};
        addPicture(one, volume, request);
        found.segments.push_back(std::move(one));
    }
    return found;
}

} // namespace ui
