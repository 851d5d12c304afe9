// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskParts.h"
#include "core/masks/SegLattice.h"
#include "core/masks/SegPlanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

using Place = LatticeMap::Place;

/// A segment's voxels of the volume, and its pixels in the file.
struct SegmentVoxels {
    VoxelRuns voxels;
    std::uint64_t pixels = 0;
};

/// The segments of a label map by their numbers, in one pass: there may be hundreds.
std::map<int, SegmentVoxels> labelMapVoxels(
    const SegFile& seg, const SegmentPlanes& planes, const LatticeMap& map, const glm::ivec3& size)
{
    std::vector<std::map<int, VoxelRuns>> slices(std::size_t(size.z));
    forEachVoxelIn(planes, map, size,
        [&](int k, std::uint64_t voxel, const PlaneFrames& plane, const Place& place) {
            planes.forEachPixel(plane, place, [&](int number) {
                if (number == 0)
                    return;
                VoxelRuns& runs = slices[std::size_t(k)][number];
                // Frames that repeat a plane may say so twice.
                if (runs.end() <= voxel)
                    runs.append(voxel, 1);
            });
        });
    std::map<int, SegmentVoxels> segments;
    for (const auto& slice : slices) {
        for (const auto& [number, runs] : slice)
            segments[number].voxels.append(runs);
    }
    for (std::size_t frame = 0; frame < seg.frames.size(); ++frame) {
        for (int row = 0; row < seg.rows; ++row) {
            for (int column = 0; column < seg.columns; ++column) {
                if (const int number = seg.value(frame, column, row))
                    ++segments[number].pixels;
            }
        }
    }
    return segments;
}

VoxelRuns voxelsOf(const SegmentPlanes& planes, const LatticeMap& map, const glm::ivec3& size)
{
    std::vector<VoxelRuns> slices(std::size_t(size.z));
    forEachVoxelIn(planes, map, size,
        [&](int k, std::uint64_t voxel, const PlaneFrames& plane, const Place& place) {
            if (planes.holds(plane, place))
                slices[std::size_t(k)].append(voxel, 1);
        });
    VoxelRuns all;
    for (const VoxelRuns& slice : slices)
        all.append(slice);
    return all;
}

/// The segment that is meant, by its place in the file. Errors: UnsupportedFormat.
Result<std::size_t> segmentNamed(const SegFile& seg, const QString& name, const QString& path)
{
    if (seg.segments.size() == 1)
        return std::size_t(0);
    QStringList names;
    for (std::size_t i = 0; i < seg.segments.size(); ++i) {
        if (seg.segments[i].label.simplified() == name.simplified() && !name.isEmpty())
            return i;
        names += seg.segments[i].label.simplified();
    }
    const QString all = names.join(QLatin1String(", "));
    return failure(ErrorCode::UnsupportedFormat, path,
        name.isEmpty()
            ? Clause::saying("it holds several segments (%1), and one is needed", all)
            : Clause::saying(
                "of its segments (%1) none has the name of the one that is divided", all));
}

} // namespace

Result<MaskOnVolume> readSegMask(
    const QString& path, const Volume& volume, const Progress& progress)
{
    const Result<SegFile> seg = readSeg(path);
    if (!seg)
        return tl::unexpected(seg.error());
    const Result<PlacedFrames> frames = placedFrames(*seg, volume, path);
    if (!frames)
        return tl::unexpected(frames.error());
    const auto& [lattice, toLattice, map] = *frames;
    MaskOnVolume mask;
    mask.notes = notesOnOrigin(seg->patient.id, seg->frameOfReferenceUid, volume);
    if (seg->type == SegFile::Type::Fractional)
        mask.notes.push_back({.code = MaskNote::Code::Fractional});
    MaskFit fit{.oneToOne = true};
    std::map<int, SegmentVoxels> labelled;
    if (seg->type == SegFile::Type::LabelMap) {
        progress.report(ProgressStep::PlacingMask, 0, int(seg->segments.size()));
        labelled =
            labelMapVoxels(*seg, SegmentPlanes(*seg, 0, toLattice), map, volume.geometry.size);
    }
    std::uint64_t taken = 0;
    int without = 0;
    for (std::size_t i = 0; i < seg->segments.size(); ++i) {
        const SegSegment& segment = seg->segments[i];
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::PlacingMask, int(i), int(seg->segments.size()));
        const SegmentPlanes planes(*seg, segment.number, toLattice);
        VoxelRuns voxels;
        // Number 0 is what a label map calls its background.
        if (!planes.empty() && segment.number != 0) {
            fit.oneToOne =
                fit.oneToOne && lattice.onSlices && planes.areUnder(map, volume.geometry.size.z);
            if (seg->type == SegFile::Type::LabelMap) {
                voxels = labelled[segment.number].voxels;
                fit.labelled += labelled[segment.number].pixels;
            } else {
                voxels = voxelsOf(planes, map, volume.geometry.size);
                fit.labelled += planes.pixelCount();
            }
        }
        taken += voxels.voxelCount();
        if (voxels.empty()) {
            without += segment.number != 0 ? 1 : 0;
            continue;
        }
        const QString name = segment.label.simplified();
        mask.segments.push_back(
            {.name = name.isEmpty() ? QStringLiteral("Segment %1").arg(segment.number) : name,
                .rgb = segment.rgb,
                .code = segment.type,
                .voxels = std::move(voxels)});
    }
    if (fit.labelled == 0)
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("no pixel belongs to a segment"));
    const HeaderPlane& plane = seg->frames.front().plane;
    fit.labelledMl =
        double(fit.labelled) * plane.rowSpacing * plane.columnSpacing * lattice.planeMm / 1000.0;
    fit.takenMl = millilitres(taken, volume.geometry);
    if (fit.oneToOne && fit.labelled > taken)
        fit.outside = fit.labelled - taken;
    const std::vector<MaskNote> onFit = notesOn(fit);
    mask.notes.insert(mask.notes.end(), onFit.begin(), onFit.end());
    if (without != 0 && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::SegmentsWithoutVoxel,
            .some = std::uint64_t(without),
            .all = seg->segments.size()});
    return mask;
}

Result<ProbabilitiesOnVolume> readSegProbabilities(
    const QString& path, const QString& segment, const Volume& volume, const Progress& progress)
{
    const Result<SegFile> seg = readSeg(path);
    if (!seg)
        return tl::unexpected(seg.error());
    if (seg->type != SegFile::Type::Fractional)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("it holds no probabilities, since its segments are not fractional"));
    const Result<std::size_t> which = segmentNamed(*seg, segment, path);
    if (!which)
        return tl::unexpected(which.error());
    const Result<PlacedFrames> frames = placedFrames(*seg, volume, path);
    if (!frames)
        return tl::unexpected(frames.error());
    progress.report(ProgressStep::PlacingMask, 0, 1);
    const SegmentPlanes planes(*seg, seg->segments[*which].number, frames->toLattice);
    ProbabilitiesOnVolume read{.probabilities = std::vector<std::uint8_t>(
                                   std::size_t(volume.geometry.voxelCount()), std::uint8_t(0)),
        .notes = notesOnOrigin(seg->patient.id, seg->frameOfReferenceUid, volume)};
    if (!planes.empty())
        forEachVoxelIn(planes, frames->map, volume.geometry.size,
            [&](int, std::uint64_t voxel, const PlaneFrames& plane, const Place& place) {
                read.probabilities[std::size_t(voxel)] = planes.probability(plane, place);
            });
    if (!frames->lattice.onSlices || !planes.areUnder(frames->map, volume.geometry.size.z))
        read.notes.push_back({.code = MaskNote::Code::MapOnAnotherGrid});
    return read;
}

} // namespace core
