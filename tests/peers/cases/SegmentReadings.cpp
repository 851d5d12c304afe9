// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/SegmentReadings.h"

#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/export/CarvedVolume.h"
#include "core/metrics/SegmentGap.h"
#include "core/nifti/NiftiReader.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/ItkDistances.h"
#include "tests/peers/ItkParts.h"
#include "tests/peers/ItkValues.h"
#include "tests/peers/cases/RealSegment.h"
#include "tests/peers/cases/SeveralSegments.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <vector>

namespace peer {

namespace {

using State = RealSegment::State;

double millisecondsOf(const QElapsedTimer& timer)
{
    return double(timer.nsecsElapsed()) / 1e6;
}

/// Carves all but the segment. @return what is carved of each voxel
core::Result<std::vector<std::uint8_t>> carveAllElse(RealSegment& segment, double& milliseconds)
{
    core::EditSession& session = segment.session();
    const core::SegmentToLayer edit{.segment = RealSegment::label,
        .layer = segment.document().layers.front().id,
        .outside = true};
    QElapsedTimer timer;
    timer.start();
    if (const core::Result<void> applied = session.apply(edit); !applied)
        return tl::unexpected(applied.error());
    if (const core::Result<void> settled = session.settle(); !settled)
        return tl::unexpected(settled.error());
    milliseconds = millisecondsOf(timer);
    return session.questions().coverage(std::uint8_t(edit.layer));
}

/// The voxels of a file.
core::Result<core::LoadedVolume> read(const QString& path)
{
    return core::readNiftiEntry(path).and_then(
        [](const core::SeriesEntry& entry) { return core::loadNifti(entry, 0, core::Progress()); });
}

std::vector<std::uint8_t> maskOf(const std::vector<std::uint8_t>& labels, int label)
{
    std::vector<std::uint8_t> mask(labels.size());
    std::transform(labels.begin(), labels.end(), mask.begin(),
        [label](std::uint8_t each) { return std::uint8_t(each == label ? 1 : 0); });
    return mask;
}

} // namespace

core::Result<ComparedVolume> compareMaskedVolume(RealSegment& segment)
{
    if (const core::Result<void> gone = segment.goTo(State::Thresholded); !gone)
        return tl::unexpected(gone.error());
    ComparedVolume compared;
    const auto carved = carveAllElse(segment, compared.stepMilliseconds);
    if (!carved)
        return tl::unexpected(carved.error());

    const core::Volume& volume = segment.document().volumes.front();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("masked.nii"));
    QElapsedTimer timer;
    timer.start();
    const auto exported = core::exportCarvedVolume(volume,
        {.target = path, .coverage = *carved, .codes = segment.codes(), .fill = volume.minimum},
        core::Progress());
    if (!exported)
        return tl::unexpected(exported.error());
    compared.exportMilliseconds = millisecondsOf(timer);
    const core::Result<core::LoadedVolume> ours = read(path);
    if (!ours)
        return tl::unexpected(ours.error());

    const ItkValues theirs =
        itkMasked(segment.values(), segment.mask(State::Thresholded), float(volume.minimum));
    compared.theirMilliseconds = theirs.milliseconds;
    compared.voxels = std::int64_t(theirs.values.size());
    const bool fits = ours->codes.size() == theirs.values.size();
    for (std::size_t voxel = 0; voxel < theirs.values.size(); ++voxel) {
        compared.masked += segment.labels(State::Thresholded)[voxel] == 0 ? 1 : 0;
        const bool isEqual =
            fits && float(ours->volume.encoding.value(ours->codes[voxel])) == theirs.values[voxel];
        compared.differing += isEqual ? 0 : 1;
    }
    if (const core::Result<void> gone = segment.goTo(State::Thresholded); !gone)
        return tl::unexpected(gone.error());
    return compared;
}

core::Result<ComparedDistances> compareDistances(const RealSegment& segment)
{
    constexpr int mostPairs = 3;
    constexpr double rounded = 1e-5; // by its floats, and by files the directions of their axes
    const std::vector<std::uint8_t> islands =
        itkNumberedParts(segment.mask(State::Thresholded), leastIslandVoxels(segment)).voxels;
    const int count = islands.empty() ? 0 : *std::max_element(islands.begin(), islands.end());
    ComparedDistances compared;
    for (int island = 1; island < count && compared.pairs < mostPairs; ++island) {
        const auto label = std::uint8_t(island);
        const auto next = std::uint8_t(island + 1);
        QElapsedTimer timer;
        timer.start();
        const auto gap =
            core::segmentGap(islands, label, islands, next, segment.geometry(), core::Progress());
        if (!gap)
            return tl::unexpected(gap.error());
        compared.ourMilliseconds += millisecondsOf(timer);

        const std::vector<std::uint8_t> own = maskOf(islands, label);
        const std::vector<std::uint8_t> others = maskOf(islands, next);
        GridMask mask = segment.mask(State::Thresholded);
        GridMask other = mask;
        mask.voxels = own;
        other.voxels = others;
        const ItkGap theirs = itkGap(mask, other);
        compared.theirMilliseconds += theirs.milliseconds;

        ++compared.pairs;
        const double mm = *gap ? glm::distance((*gap)->fromLps, (*gap)->toLps) : -1.0;
        compared.greatestMm = std::max(compared.greatestMm, mm);
        compared.differing += std::abs(mm - theirs.mm) <= rounded * theirs.mm ? 0 : 1;
    }
    return compared;
}

} // namespace peer
