// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/SegmentStatistics.h"

#include "core/brick/LabelRuns.h"
#include "core/brick/VoxelRunSets.h"
#include "core/export/common/CheckSources.h"
#include "core/surface/LongestDistance.h"
#include "core/surface/SegmentSurface.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {

namespace {

/// What one pass over the voxels counts; whole numbers only.
struct Counts {
    std::vector<std::int64_t> ofCode = std::vector<std::int64_t>(VoxelEncoding::codeCount, 0);
    std::vector<std::int64_t> ofSlice;
    std::vector<std::int64_t> columnSums; ///< per slice
    std::vector<std::int64_t> rowSums;
    glm::ivec3 first{0};
    glm::ivec3 last{-1};
    std::int64_t voxels = 0;
};

Counts countsOf(std::span<const std::uint8_t> labels, std::uint8_t label,
    std::span<const std::uint16_t> codes, const glm::ivec3& size)
{
    Counts counts;
    const auto slices = std::size_t(size.z);
    counts.ofSlice.resize(slices);
    counts.columnSums.resize(slices);
    counts.rowSums.resize(slices);
    counts.first = size;
    std::size_t i = 0;
    for (int z = 0; z < size.z; ++z) {
        const auto k = std::size_t(z);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++i) {
                if (labels[i] != label)
                    continue;
                ++counts.ofCode[codes[i]];
                ++counts.ofSlice[k];
                counts.columnSums[k] += x;
                counts.rowSums[k] += y;
                counts.first = glm::min(counts.first, glm::ivec3(x, y, z));
                counts.last = glm::max(counts.last, glm::ivec3(x, y, z));
            }
        }
        counts.voxels += counts.ofSlice[k];
    }
    return counts;
}

/// The least code that @p share percent of the voxels do not exceed.
int percentileCode(const Counts& counts, int share)
{
    const std::int64_t wanted =
        std::max<std::int64_t>(1, (counts.voxels * share + 99) / 100); // rounded up
    std::int64_t reached = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        reached += counts.ofCode[std::size_t(code)];
        if (reached >= wanted)
            return code;
    }
    return VoxelEncoding::codeCount - 1;
}

void measureValues(SegmentStatistics& found, const Counts& counts, const VoxelEncoding& encoding)
{
    std::int64_t sum = 0;
    int least = VoxelEncoding::codeCount;
    int greatest = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        const std::int64_t many = counts.ofCode[std::size_t(code)];
        if (many == 0)
            continue;
        sum += many * code;
        least = std::min(least, code);
        greatest = code;
    }
    const double meanCode = double(sum) / double(counts.voxels);
    double squares = 0.0;
    for (int code = least; code <= greatest; ++code)
        squares += double(counts.ofCode[std::size_t(code)]) * (code - meanCode) * (code - meanCode);
    // Values are linear in codes.
    const double step = encoding.rescaleSlope * encoding.storedStep;
    found.minimum = encoding.value(least);
    found.maximum = encoding.value(greatest);
    found.mean = encoding.value(0) + step * meanCode;
    found.deviation = std::abs(step) * std::sqrt(squares / double(counts.voxels));
    found.median = encoding.value(percentileCode(counts, 50));
    for (std::size_t i = 0; i < statisticsPercentiles.size(); ++i)
        found.percentiles[i] = encoding.value(percentileCode(counts, statisticsPercentiles[i]));
}

void measurePlace(SegmentStatistics& found, const Counts& counts, const VolumeGeometry& geometry)
{
    found.first = counts.first;
    found.last = counts.last;
    const glm::dmat3 axes(geometry.indexToWorld);
    const double pixelMm2 = glm::length(glm::cross(axes[0], axes[1]));
    const std::vector<double> thickness = sliceThicknessesMm(geometry);
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < counts.ofSlice.size(); ++k) {
        const auto many = double(counts.ofSlice[k]);
        found.millilitres += many * pixelMm2 * thickness[k] / 1000.0;
        sum += many * sliceOrigin(geometry, int(k)) + double(counts.columnSums[k]) * axes[0]
            + double(counts.rowSums[k]) * axes[1];
    }
    found.centroidLps = sum / double(counts.voxels);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 index((corner & 1) != 0 ? counts.last.x : counts.first.x,
            (corner & 2) != 0 ? counts.last.y : counts.first.y,
            (corner & 4) != 0 ? counts.last.z : counts.first.z);
        const glm::dvec3 place =
            sliceOrigin(geometry, index.z) + double(index.x) * axes[0] + double(index.y) * axes[1];
        found.lowestLps = corner == 0 ? place : glm::min(found.lowestLps, place);
        found.highestLps = corner == 0 ? place : glm::max(found.highestLps, place);
    }
}

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

/// None if nothing was imported as the segment.
std::optional<ChangeSinceImport> sinceImport(const ExportRequest& request, const Segment& segment,
    std::span<const std::uint8_t> labels, const VolumeGeometry& geometry)
{
    const auto its = std::find_if(request.imported.begin(), request.imported.end(),
        [&](const ImportedVoxels& each) { return each.label == segment.label; });
    if (its == request.imported.end())
        return std::nullopt;
    const VoxelRuns own = labelRuns(labels, segment.label);
    const VoxelRuns changed = differing(own, its->voxels);
    return ChangeSinceImport{.addedMl = millilitresOf(common(changed, own), geometry),
        .takenMl = millilitresOf(common(changed, its->voxels), geometry),
        .dice = 2.0 * double(sharedVoxels(own, its->voxels))
            / double(own.voxelCount() + its->voxels.voxelCount())};
}

void measureSurface(
    SegmentStatistics& found, const SegmentSurface& surface, const VolumeGeometry& geometry)
{
    std::vector<glm::dvec3> places;
    places.reserve(surface.vertices.size());
    for (const glm::vec3& vertex : surface.vertices)
        places.push_back(worldBetweenSlices(geometry, glm::dvec3(vertex)));
    double twice = 0.0;
    double sixfold = 0.0;
    for (const glm::uvec3& triangle : surface.triangles) {
        // Volumes are counted from a point nearby; far away, rounding would take their last digits.
        const glm::dvec3 a = places[triangle.x];
        const glm::dvec3 normal = glm::cross(places[triangle.y] - a, places[triangle.z] - a);
        twice += glm::length(normal);
        sixfold += glm::dot(a - places.front(), normal);
    }
    found.surfaceMm2 = twice / 2.0;
    // Negative where the index axes are left-handed.
    const double enclosedMm3 = std::abs(sixfold) / 6.0;
    if (found.surfaceMm2 > 0.0)
        found.sphericity =
            std::cbrt(36.0 * std::numbers::pi * enclosedMm3 * enclosedMm3) / found.surfaceMm2;
    found.longestMm = longestDistance(std::move(places));
}

} // namespace

Result<std::vector<SegmentStatistics>> segmentStatistics(const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress)
{
    std::vector<SegmentStatistics> all;
    for (const Segment& segment : selection.segments) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::Measuring, int(all.size()), int(selection.segments.size()));
        const auto labels = planeOf(request, segment)->labels;
        const Counts counts = countsOf(labels, segment.label, request.codes, volume.geometry.size);
        SegmentStatistics found;
        found.segment = segment;
        found.voxels = counts.voxels;
        measureValues(found, counts, volume.encoding);
        measurePlace(found, counts, volume.geometry);
        measureSurface(
            found, segmentSurface(labels, segment.label, volume.geometry.size), volume.geometry);
        found.sinceImport = sinceImport(request, segment, labels, volume.geometry);
        all.push_back(found);
    }
    return all;
}

} // namespace core
