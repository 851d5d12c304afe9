// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/LabelMap.h"

#include "core/export/common/CheckSources.h"
#include "core/repair/RepairVolume.h"

#include <algorithm>
#include <bitset>
#include <iterator>
#include <set>

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

/// A map without voxels, if there can be one.
Result<LabelMap> emptyMap(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report)
{
    const auto unsupported = [&](const Clause& what) {
        return failure(ErrorCode::UnsupportedFormat, request.file, what);
    };
    const Clause uneven = oneStepObstacle(volume, format,
        Clause::saying("DICOM SEG keeps every slice in its place"), report.cautions);
    if (!uneven.isEmpty())
        return unsupported(uneven);
    LabelMap map;
    map.layerOf.resize(selection.segments.size(), 0);
    std::bitset<256> used;
    for (const Segment& segment : selection.segments) {
        if (used.test(segment.label))
            return unsupported(
                Clause::saying("two of the segments have label %1, which one %2 label map cannot "
                               "hold; export them one by one, or as DICOM SEG",
                    segment.label, format));
        used.set(segment.label);
        map.names += QStringLiteral("%1 %2").arg(segment.label).arg(segment.name);
    }
    return map;
}

void fill(LabelMap& map, const ExportRequest& request, const MaskSelection& selection)
{
    const std::size_t voxels = planeOf(request, selection.segments.front())->labels.size();
    const auto layers = std::size_t(map.layers);
    map.labels.resize(voxels * layers, 0);
    for (std::size_t s = 0; s < selection.segments.size(); ++s) {
        const Segment& segment = selection.segments[s];
        const auto labels = planeOf(request, segment)->labels;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i] == segment.label)
                map.labels[i * layers + std::size_t(map.layerOf[s])] = segment.label;
        }
    }
}

} // namespace

ReportSentence gridName(const Volume& volume)
{
    const QString repair = repairMade(volume);
    return volume.asIs && volume.sources.empty() && !repair.isEmpty()
        ? ReportSentence{ReportCode::RepairedGrid, {repair}}
        : ReportSentence{ReportCode::SourceGrid};
}

Clause oneStepObstacle(
    const Volume& volume, const QString& format, const Clause& instead, ReportLines& cautions)
{
    const double uneven = unevennessMm(volume.geometry);
    if (uneven > unevenLimit * volume.geometry.spacingMm().z)
        return Clause::saying(
            "%1 has one step for all slices, and these stray from it by up to %2 mm; %3", format,
            QString::number(uneven, 'f', 2), instead);
    if (uneven > 0.0)
        cautions +=
            ReportSentence{ReportCode::UnevenInFile, {format, QString::number(uneven, 'f', 3)}};
    return {};
}

Result<LabelMap> labelMapOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report)
{
    Result<LabelMap> map = emptyMap(volume, request, selection, format, report);
    if (!map)
        return map;
    if (const Clause why = whyNoLabelMap(request, selection.segments, format); !why.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.file, why);
    fill(*map, request, selection);
    return map;
}

Result<LabelMap> labelLayersOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report)
{
    Result<LabelMap> map = emptyMap(volume, request, selection, format, report);
    if (!map)
        return map;
    if (!whyNoLabelMap(request, selection.segments, format).isEmpty()) {
        std::set<std::uint8_t> planes;
        for (const Segment& segment : selection.segments)
            planes.insert(segment.plane);
        for (std::size_t s = 0; s < selection.segments.size(); ++s)
            map->layerOf[s] =
                int(std::distance(planes.begin(), planes.find(selection.segments[s].plane)));
        map->layers = int(planes.size());
    }
    fill(*map, request, selection);
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
    return wrongVoxels(voxels, expected, std::vector<int>(expected.segments.size(), 0), 1);
}

std::size_t wrongVoxels(std::span<const std::uint8_t> voxels, const ExportExpectation& expected,
    const std::vector<int>& layerOf, int layers)
{
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < voxels.size() / std::size_t(layers); ++i) {
        bool differs = false;
        for (int layer = 0; layer < layers; ++layer) {
            std::uint8_t label = 0;
            for (std::size_t s = 0; s < expected.segments.size(); ++s) {
                const Segment& segment = expected.segments[s];
                for (const LabelPlaneView& plane : expected.planes) {
                    if (layerOf[s] == layer && plane.plane == segment.plane
                        && plane.labels[i] == segment.label)
                        label = segment.label;
                }
            }
            differs = differs || voxels[i * std::size_t(layers) + std::size_t(layer)] != label;
        }
        wrong += differs ? 1U : 0U;
    }
    return wrong;
}

} // namespace core
