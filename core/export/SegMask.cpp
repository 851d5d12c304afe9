// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SegWriter.h"
#include "core/export/CheckSources.h"
#include "core/export/MaskSelection.h"

#include <cmath>

namespace core {

namespace {

/// True where two segments share a voxel; only segments of different planes can.
bool overlap(const ExportRequest& request, const std::vector<Segment>& segments)
{
    for (std::size_t a = 0; a < segments.size(); ++a) {
        for (std::size_t b = a + 1; b < segments.size(); ++b) {
            if (segments[a].plane == segments[b].plane)
                continue;
            const auto first = planeOf(request, segments[a])->labels;
            const auto second = planeOf(request, segments[b])->labels;
            for (std::size_t i = 0; i < first.size(); ++i) {
                if (first[i] == segments[a].label && second[i] == segments[b].label)
                    return true;
            }
        }
    }
    return false;
}

} // namespace

Result<QStringList> writeSegMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    SegContent content;
    content.identity = volume.identity;
    content.sources = volume.sources;
    content.keptHeaders = volume.keptHeaders;
    content.columns = geometry.size.x;
    content.rows = geometry.size.y;
    if (geometry.slicePositions.empty() && geometry.size.z > 1) {
        const glm::dmat3 axes(geometry.indexToWorld);
        content.sliceDistanceMm =
            std::abs(glm::dot(axes[2], glm::normalize(glm::cross(axes[0], axes[1]))));
    }
    content.segments = selection.segments;
    content.category = request.category;
    content.segmentsOverlap = overlap(request, selection.segments);
    FrameBits bits;
    const std::size_t count = voxelsPerSlice(volume);
    for (std::size_t s = 0; s < selection.segments.size(); ++s) {
        const auto labels = planeOf(request, selection.segments[s])->labels;
        for (const int k : selection.slices[s]) {
            content.frames.push_back({.segment = int(s), .slice = k});
            bits.append(labels.subspan(std::size_t(k) * count, count), selection.segments[s].label);
        }
    }
    content.bits = bits.take();
    const auto written = writeSeg(path, content, progress);
    if (!written)
        return tl::unexpected(written.error());
    report.cautions += written->notes;
    if (volume.identity.frameOfReferenceUid.isEmpty())
        report.cautions += QStringLiteral(
            "The source images have no frame of reference in common; the segmentation names none.");
    return QStringList{QStringLiteral(
        "DICOM SEG, binary: %1 in %2 of %3 × %4; slices without a voxel are left out.")
                           .arg(counted(int(content.segments.size()), "segment"),
                               counted(int(content.frames.size()), "frame"))
                           .arg(content.columns)
                           .arg(content.rows)};
}

} // namespace core
