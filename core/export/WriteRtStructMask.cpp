// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"
#include "core/dicom/write/RtStructWriter.h"
#include "core/export/common/CheckSources.h"
#include "core/export/common/MaskSelection.h"
#include "core/repair/RepairVolume.h"
#include "core/surface/SliceContours.h"

namespace core {

Result<ReportLines> writeRtStructMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report)
{
    RtStructContent content;
    content.identity = volume.identity;
    content.repair = repairMade(volume);
    content.sources = volume.sources;
    content.keptHeaders = volume.keptHeaders;
    content.segments = selection.segments;
    content.deidentifier = request.deidentifier;
    const glm::ivec2 size(volume.geometry.size);
    const std::size_t count = voxelsPerSlice(volume);
    std::size_t points = 0;
    for (std::size_t s = 0; s < selection.segments.size(); ++s) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::TracingContours, int(s), int(selection.segments.size()));
        const auto labels = planeOf(request, selection.segments[s])->labels;
        const std::vector<int>& slices = selection.slices[s];
        std::vector<std::vector<SliceContour>> ofSlice(slices.size());
        parallelFor(int(slices.size()), [&](int i) {
            const auto slice = std::size_t(slices[std::size_t(i)]);
            ofSlice[std::size_t(i)] = sliceContours(
                labels.subspan(slice * count, count), selection.segments[s].label, size);
        });
        for (std::size_t i = 0; i < slices.size(); ++i) {
            for (SliceContour& contour : ofSlice[i]) {
                points += contour.size();
                content.contours.push_back(
                    {.segment = int(s), .slice = slices[i], .corners = std::move(contour)});
            }
        }
    }
    const auto written = writeRtStruct(path, content, progress);
    if (!written)
        return tl::unexpected(written.error());
    report.cautions += written->notes;
    if (volume.identity.frameOfReferenceUid.isEmpty())
        report.cautions += ReportSentence{ReportCode::NewFrameOfReference};
    return ReportLines{ReportSentence{ReportCode::RtStruct,
        {countedInReport(ReportCode::Segments, std::int64_t(content.segments.size())),
            countedInReport(ReportCode::Contours, std::int64_t(content.contours.size())),
            std::int64_t(points)}}};
}

} // namespace core
