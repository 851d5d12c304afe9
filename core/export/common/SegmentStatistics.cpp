// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/SegmentStatistics.h"

#include "core/brick/LabelRuns.h"
#include "core/brick/VoxelRunSets.h"
#include "core/export/common/SegmentMeter.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>

namespace core {

namespace {

double millilitresOf(const VoxelRuns& voxels, const VolumeGeometry& geometry)
{
    const std::vector<double> thickness = sliceThicknessesMm(geometry);
    std::vector<std::int64_t> ofSlice(thickness.size(), 0);
    const auto slice = std::uint64_t(geometry.size.x) * std::uint64_t(geometry.size.y);
    for (const VoxelRun& run : voxels.runs()) {
        std::uint64_t at = run.first;
        std::uint64_t left = run.count;
        while (left > 0) {
            const std::uint64_t count = std::min(left, slice - at % slice);
            ofSlice[std::size_t(at / slice)] += std::int64_t(count);
            at += count;
            left -= count;
        }
    }
    const glm::dmat3 axes(geometry.indexToWorld);
    const double pixelMm2 = glm::length(glm::cross(axes[0], axes[1]));
    double millilitres = 0.0;
    for (std::size_t k = 0; k < ofSlice.size(); ++k)
        millilitres += double(ofSlice[k]) * pixelMm2 * thickness[k] / 1000.0;
    return millilitres;
}

} // namespace

std::optional<ChangeSinceImport> changeSinceImport(const VoxelRuns& now, int label,
    const std::vector<ImportedVoxels>& imported, const VolumeGeometry& geometry)
{
    const auto its = std::find_if(imported.begin(), imported.end(),
        [label](const ImportedVoxels& each) { return int(each.label) == label; });
    if (its == imported.end())
        return std::nullopt;
    const VoxelRuns changed = differing(now, its->voxels);
    return ChangeSinceImport{.addedMl = millilitresOf(common(changed, now), geometry),
        .takenMl = millilitresOf(common(changed, its->voxels), geometry),
        .dice = 2.0 * double(sharedVoxels(now, its->voxels))
            / double(now.voxelCount() + its->voxels.voxelCount())};
}

Result<std::vector<SegmentStatistics>> segmentStatistics(const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress)
{
    std::vector<SegmentStatistics> all;
    for (const Segment& segment : selection.segments) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::Measuring, int(all.size()), int(selection.segments.size()));
        const auto labels = planeOf(request, segment)->labels;
        SegmentMeter meter(volume.geometry, volume.encoding, segment, labels);
        meter.count({.maximum = volume.geometry.size}, request.codes);
        SegmentStatistics found = meter.statistics();
        if (!request.imported.empty())
            found.sinceImport = changeSinceImport(
                labelRuns(labels, segment.label), segment.label, request.imported, volume.geometry);
        all.push_back(found);
    }
    return all;
}

} // namespace core
