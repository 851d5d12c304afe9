// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/LabelMap.h"

#include "core/export/common/CheckSources.h"

#include <algorithm>
#include <bitset>

namespace core {

namespace {

/// A slice step that strays further than this share of itself cannot be called even.
constexpr double unevenLimit = 0.1;

/// How far the slices stray from the affine; 0 for an even stack.
double unevennessMm(const VolumeGeometry& geometry)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < geometry.slicePositions.size(); ++k)
        worst = std::max(worst,
            glm::distance(geometry.slicePositions[k], geometry.toWorld({0.0, 0.0, double(k)})));
    return worst;
}

} // namespace

ReportSentence gridName(const Volume& volume)
{
    return volume.asIs && volume.sources.empty()
        ? ReportSentence{ReportCode::RepairedGrid, {volume.repair}}
        : ReportSentence{ReportCode::SourceGrid};
}

Result<LabelMap> labelMapOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    const auto unsupported = [&](const Clause& what) {
        return failure(ErrorCode::UnsupportedFormat, request.file, what);
    };
    const double uneven = unevennessMm(geometry);
    if (uneven > unevenLimit * geometry.spacingMm().z)
        return unsupported(
            Clause::saying("%1 has one step for all slices, and these stray from it by up to %2 "
                           "mm; DICOM SEG keeps every slice in its place",
                format, QString::number(uneven, 'f', 2)));
    if (uneven > 0.0)
        report.cautions +=
            ReportSentence{ReportCode::UnevenInFile, {format, QString::number(uneven, 'f', 3)}};
    LabelMap map;
    map.labels.resize(geometry.voxelCount(), 0);
    std::bitset<256> used;
    for (const Segment& segment : selection.segments) {
        if (used.test(segment.label))
            return unsupported(
                Clause::saying("two of the segments have label %1, which one %2 label map cannot "
                               "hold; export them one by one, or as DICOM SEG",
                    segment.label, format));
        used.set(segment.label);
        map.names += QStringLiteral("%1 %2").arg(segment.label).arg(segment.name);
        const auto labels = planeOf(request, segment)->labels;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i] == segment.label)
                map.labels[i] = segment.label;
        }
    }
    if (const Clause why = whyNoLabelMap(request, selection.segments, format); !why.isEmpty())
        return unsupported(why);
    return map;
}

Result<LabelMapPlace> labelMapPlace(
    const QString& file, const Volume& volume, const Progress& progress)
{
    const auto corners = sourceCorners(file, volume, progress);
    if (!corners)
        return tl::unexpected(corners.error());
    const VolumeGeometry& geometry = volume.geometry;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double least = std::min({spacing.x, spacing.y, spacing.z});
    // Far from the origin a 32-bit float has a step of its own; never near half a voxel, though.
    // Uneven slices stray from the single step of a map; by how much, the export's report says.
    const int last = geometry.size.z - 1;
    const double uneven = std::max(glm::distance(sliceOrigin(geometry, 0), geometry.originLps()),
        glm::distance(sliceOrigin(geometry, last), geometry.toWorld({0.0, 0.0, double(last)})));
    const double tolerance = positionToleranceMm(geometry) + 0.1 * least + uneven;
    const double ofVolume = farthest(*corners, cornersOf(geometry.indexToWorld, geometry.size));
    if (ofVolume > tolerance)
        return failure(ErrorCode::ExportMismatch, file,
            Clause::saying("the source's own header puts a corner %1 mm away from where the volume "
                           "has it",
                ofVolume));
    return LabelMapPlace{.corners = *corners, .toleranceMm = tolerance};
}

std::size_t wrongVoxels(std::span<const std::uint8_t> voxels, const ExportExpectation& expected)
{
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        std::uint8_t label = 0;
        for (const Segment& segment : expected.segments) {
            for (const LabelPlaneView& plane : expected.planes) {
                if (plane.plane == segment.plane && plane.labels[i] == segment.label)
                    label = segment.label;
            }
        }
        wrong += voxels[i] != label ? 1U : 0U;
    }
    return wrong;
}

} // namespace core
