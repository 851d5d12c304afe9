// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"
#include "core/base/StepCounter.h"
#include "core/images/ImageCodec.h"
#include "core/images/ImagePage.h"
#include "core/images/ImageStack.h"

#include <QFileInfo>

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

namespace core {

namespace {

/// One slice on its way: what it is read from, and why it is empty where it is.
struct Slice {
    ImagePage page;
    Clause wrong{};
};

/// The slices of an entry as its files have them now.
std::vector<Slice> slicesOf(const SeriesEntry& entry)
{
    std::vector<Slice> slices;
    for (const QString& file : entry.files) {
        Result<std::vector<ImagePage>> pages = readImagePages(file);
        if (!pages) {
            slices.push_back({.page = {.file = file}, .wrong = pages.error().arguments.value(1)});
            continue;
        }
        for (ImagePage& page : *pages)
            slices.push_back({.page = std::move(page)});
    }
    return slices;
}

tl::unexpected<Error> changed(const SeriesEntry& entry)
{
    return failure(ErrorCode::InvalidGeometry, stackPath(entry),
        Clause::saying("its pictures were changed meanwhile"));
}

void reportEmptySlices(const std::vector<Slice>& slices, Volume& volume)
{
    for (std::size_t k = 0; k < slices.size(); ++k) {
        if (slices[k].wrong.isEmpty())
            continue;
        const int number = int(k) + 1;
        volume.problems.push_back({.kind = VolumeProblem::Kind::DamagedSlice,
            .said = {ProblemCode::PictureLeftEmpty,
                {number, QFileInfo(slices[k].page.file).fileName(), slices[k].wrong.english()}},
            .caution = true,
            .slices = {{.first = number, .last = number}}});
    }
}

} // namespace

Result<LoadedVolume> loadImageStack(const SeriesEntry& entry, const Progress& progress)
{
    std::vector<Slice> slices = slicesOf(entry);
    const auto isSound = [](const Slice& slice) { return slice.wrong.isEmpty(); };
    const auto first = std::find_if(slices.begin(), slices.end(), isSound);
    const glm::ivec3 size = entry.geometry.size;
    if (slices.size() != std::size_t(size.z) || first == slices.end())
        return changed(entry);
    const ImagePage like = first->page;
    const bool alike = std::all_of(slices.begin(), slices.end(),
        [&](const Slice& slice) { return !isSound(slice) || slice.page.isLike(like); });
    if (!alike || like.columns != size.x || like.rows != size.y)
        return changed(entry);

    const std::size_t each = like.byteCount();
    const std::size_t bytes = each * slices.size();
    if (const Result<void> fits = checkScalarMemory(entry.geometry.voxelCount(), like.type); !fits)
        return tl::unexpected<Error>(fits.error());
    LoadedVolume loaded;
    Volume& volume = loaded.volume;
    volume.geometry = entry.geometry;
    const bool inRoom = fitsCodes(like.type);
    // Zeros, which an empty slice keeps.
    const std::unique_ptr<char[]> wide = inRoom ? nullptr : std::make_unique<char[]>(bytes);
    const std::span<char> voxels =
        inRoom ? roomForScalars(loaded, like.type) : std::span<char>(wide.get(), bytes);
    StepCounter counter(progress, ProgressStep::ReadingVoxels, int(slices.size()));
    parallelFor(int(slices.size()), [&](int k) {
        Slice& slice = slices[std::size_t(k)];
        if (progress.cancelled() || !isSound(slice))
            return;
        slice.wrong = decodeImageFenced(slice.page, [&](std::span<const std::uint8_t> pixels) {
            std::memcpy(voxels.data() + std::size_t(k) * each, pixels.data(), pixels.size());
        });
        counter.stepDone();
    });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    if (std::none_of(slices.begin(), slices.end(), isSound))
        return failure(ErrorCode::FileUnreadable, slices.front().page.file, slices.front().wrong);

    volume.identity = entry.identity;
    volume.sourceFormat = QLatin1String(imageFormatName);
    volume.problems = entry.problems;
    volume.displayInverted = like.isInverted;
    reportEmptySlices(slices, volume);
    if (inRoom)
        encodeScalarsInRoom(loaded, like.type, 1.0, 0.0, false);
    else
        encodeScalars(loaded, voxels, like.type, 1.0, 0.0, false);
    return loaded;
}

} // namespace core
