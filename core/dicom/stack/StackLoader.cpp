// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/StackLoader.h"

#include "core/base/LargePages.h"
#include "core/base/ParallelFor.h"
#include "core/base/StepCounter.h"
#include "core/base/TaskThread.h"
#include "core/dicom/codecs/FrameDecoder.h"
#include "core/dicom/header/ModalityLut.h"
#include "core/dicom/stack/StackGeometry.h"
#include "core/volume/MemoryLimit.h"
#include "core/volume/encoding/StoredEncoder.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace core {

namespace {

/// Exact values of a stack whose pixels do not fit 16 bits. Fails with the first slice that does.
Result<std::vector<double>> decodeNumbers(const SliceStack& stack, const Progress& progress)
{
    const std::size_t size =
        std::size_t(stack.geometry.size.x) * std::size_t(stack.geometry.size.y);
    // Four times what the codes take, for as long as they are made.
    if (const Result<void> fits = checkMemory(5 * stack.geometry.voxelCount()); !fits)
        return tl::unexpected<Error>(fits.error());
    std::vector<double> values(stack.geometry.voxelCount());
    int done = 0;
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const ImageHeader& image = stack.slices[k];
        const Result<FrameFile> file = FrameFile::open(image.file);
        if (!file)
            return tl::unexpected<Error>(file.error());
        const std::span<double> slice = std::span(values).subspan(k * size, size);
        if (const Result<void> read = file->decodeNumbers(image, slice); !read)
            return tl::unexpected<Error>(read.error());
        for (double& value : slice)
            value = image.slope * value + image.intercept;
        progress.report(ProgressStep::ReadingSlices, ++done, int(stack.slices.size()));
    }
    return values;
}

/// The files that hold several of a stack's slices, each opened when its first slice is decoded and
/// then used by all threads.
class SharedFiles {
public:
    explicit SharedFiles(const std::vector<ImageHeader>& slices)
    {
        for (const ImageHeader& image : slices) {
            if (image.frames > 1 && !m_files.contains(image.file))
                m_files.emplace(image.file, std::make_unique<Slot>());
        }
    }

    /// What is stored, through its lookup table where there is one.
    [[nodiscard]] Result<void> decode(const ImageHeader& image, std::span<std::uint16_t> stored)
    {
        const Result<DecodedFrame> decoded = decodeStored(image, stored);
        if (!decoded)
            return tl::unexpected<Error>(decoded.error());
        if (decoded->cutOff)
            m_cutOff = true;
        if (image.modalityLut)
            image.modalityLut->apply(stored, image.layout.isSigned);
        return {};
    }

    /// That values did not fit, after all slices are decoded.
    void report(std::vector<VolumeProblem>& problems) const
    {
        if (m_cutOff)
            problems.push_back({.kind = VolumeProblem::Kind::Other,
                .said = {ProblemCode::ValuesCutOff},
                .caution = true});
    }

private:
    [[nodiscard]] Result<DecodedFrame> decodeStored(
        const ImageHeader& image, std::span<std::uint16_t> stored)
    {
        const auto found = m_files.find(image.file);
        if (found == m_files.end())
            return decodeFrame(image, stored);
        Slot& slot = *found->second;
        std::call_once(slot.once, [&] { slot.file.emplace(FrameFile::open(image.file)); });
        if (!*slot.file)
            return tl::unexpected<Error>(slot.file->error());
        return (*slot.file)->decode(image, stored);
    }

    struct Slot {
        std::once_flag once;
        std::optional<Result<FrameFile>> file;
    };
    std::map<QString, std::unique_ptr<Slot>> m_files; ///< does not change while threads look
    std::atomic<bool> m_cutOff = false; ///< values of some image did not fit its stored bits
};

int middleOf(const SliceStack& stack)
{
    return int(stack.slices.size() / 2);
}

using Stored = std::vector<std::uint16_t>;
using Errors = std::vector<std::optional<Error>>;

std::size_t sliceSize(const SliceStack& stack)
{
    return std::size_t(stack.geometry.size.x) * std::size_t(stack.geometry.size.y);
}

/// Decodes all slices into the codes of @p loaded.
/// @param decode of slice k @param there told of each that is decoded, on the thread that did it
/// @return per slice
Errors decodeAll(const SliceStack& stack, LoadedVolume& loaded, const Progress& progress,
    const std::function<Result<void>(int k, std::span<std::uint16_t> stored)>& decode,
    const std::function<void(int k)>& there)
{
    const std::size_t size = sliceSize(stack);
    Errors errors(stack.slices.size());
    StepCounter counter(progress, ProgressStep::ReadingSlices, int(stack.slices.size()));
    parallelFor(int(stack.slices.size()), [&](int k) {
        if (progress.cancelled())
            return;
        const auto slot = std::size_t(k);
        const Result<void> decoded = decode(k, std::span(loaded.codes).subspan(slot * size, size));
        if (decoded)
            there(k);
        else
            errors[slot] = decoded.error();
        counter.stepDone();
    });
    return errors;
}

/// Whether a problem is one of the images or their files, which slices that are left out do not
/// change. Those of places and pixels are found anew.
bool isOfImages(const VolumeProblem& problem)
{
    switch (problem.kind) {
    case VolumeProblem::Kind::MixedSlices:
    case VolumeProblem::Kind::DoubledSlices:
    case VolumeProblem::Kind::DuplicateSlices:
    case VolumeProblem::Kind::DamagedSlice:
        return true;
    case VolumeProblem::Kind::MissingSlices:
    case VolumeProblem::Kind::UnevenSpacing:
    case VolumeProblem::Kind::Tilt:
    case VolumeProblem::Kind::AssumedSpacing:
    case VolumeProblem::Kind::LossyCompression:
    case VolumeProblem::Kind::InexactValues:
        return false;
    case VolumeProblem::Kind::Other:
        return problem.said.code == ProblemCode::FramesOfReferenceTakenAsOne;
    }
    return false;
}

/// The spans without the slices that failed, in the numbers of those that are left.
std::vector<SliceSpan> spansOfRest(const std::vector<SliceSpan>& spans, const Errors& errors)
{
    std::vector<int> left{0}; // of the slices up to each
    for (const std::optional<Error>& error : errors)
        left.push_back(left.back() + (error ? 0 : 1));
    const auto leftTo = [&left](int slice) {
        return left[std::size_t(std::clamp(slice, 0, int(left.size()) - 1))];
    };
    std::vector<SliceSpan> rest;
    for (const SliceSpan& span : spans) {
        const SliceSpan here{.first = leftTo(span.first - 1) + 1, .last = leftTo(span.last)};
        if (here.first <= here.last)
            rest.push_back(here);
    }
    return rest;
}

/// What remains true of a stack when slices failed. The sentences keep the numbers of the whole
/// stack, as that about the slices that failed does.
std::vector<VolumeProblem> problemsOfImages(const SliceStack& stack, const Errors& errors)
{
    std::vector<VolumeProblem> kept;
    for (const VolumeProblem& problem : stack.problems) {
        if (!isOfImages(problem))
            continue;
        kept.push_back(problem);
        kept.back().slices = spansOfRest(problem.slices, errors);
    }
    return kept;
}

/// Leaves out the slices that failed; the rest is placed anew.
SliceStack withoutFailed(
    const SliceStack& stack, std::vector<std::uint16_t>& codes, const Errors& errors)
{
    const std::size_t size = sliceSize(stack);
    std::vector<ImageHeader> sound;
    std::vector<UndecodedSlice> failed;
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        if (const std::optional<Error>& error = errors[k]) {
            failed.push_back({.number = int(k) + 1,
                .image = imageName(stack.slices[k]),
                .reason = error->arguments.value(1)});
            continue;
        }
        std::copy_n(codes.begin() + std::ptrdiff_t(k * size), size,
            codes.begin() + std::ptrdiff_t(sound.size() * size));
        sound.push_back(stack.slices[k]);
    }
    codes.resize(sound.size() * size);
    SliceStack rest = stackOf(std::move(sound));
    rest.part = stack.part;
    rest.time = stack.time;
    const std::vector<VolumeProblem> kept = problemsOfImages(stack, errors);
    rest.problems.insert(rest.problems.begin(), kept.begin(), kept.end());
    rest.problems.push_back(undecodedSlices(failed));
    return rest;
}

/// All but the voxels and what follows from them.
Volume describe(const ListedStack& listed, const SliceStack& stack)
{
    Volume volume;
    volume.identity = listed.entry.identity;
    volume.geometry = stack.geometry;
    volume.unit = listed.entry.unit;
    volume.sourceFormat = QStringLiteral("DICOM");
    volume.problems = stack.problems;
    const ImageHeader& middle = stack.slices[std::size_t(middleOf(stack))];
    volume.displayInverted = middle.inverted;
    if (middle.window)
        volume.defaultWindow = *middle.window;
    for (const ImageHeader& image : stack.slices) {
        volume.sources.push_back({.file = image.file,
            .sopInstanceUid = image.sopInstanceUid,
            .sopClassUid = image.sopClassUid,
            .frame = image.frame,
            .instanceNumber = image.instanceNumber});
    }
    return volume;
}

bool hasWindow(const SliceStack& stack)
{
    return stack.slices[std::size_t(middleOf(stack))].window.has_value();
}

std::vector<SliceRescale> rescalesOf(const SliceStack& stack)
{
    std::vector<SliceRescale> rescales;
    for (const ImageHeader& image : stack.slices) {
        rescales.push_back({.slope = image.slope,
            .intercept = image.intercept,
            .isSigned = image.layout.isSigned && !image.modalityLut,
            .padding = image.modalityLut ? std::nullopt : image.padding});
    }
    return rescales;
}

std::shared_ptr<const EarlySlice> earlySlice(const ListedStack& listed, const SliceStack& stack,
    const SliceRescale& rescale, const Stored& stored)
{
    auto early = std::make_shared<EarlySlice>();
    early->volume = describe(listed, stack);
    early->slice = middleOf(stack);
    early->codes = stored;
    encodeSlice(early->volume, early->codes, rescale);
    return early;
}

Result<LoadedVolume> loadStored(const ListedStack& listed, const SliceStack& wanted,
    const Progress& progress, const EarlySliceListener& early)
{
    if (const Result<void> fits = checkMemory(wanted.geometry.voxelCount()); !fits)
        return tl::unexpected<Error>(fits.error());
    const std::vector<SliceRescale> rescales = rescalesOf(wanted);
    const auto middle = std::size_t(middleOf(wanted));
    LoadedVolume loaded;
    loaded.volume.geometry = wanted.geometry;
    SharedFiles files(wanted.slices);
    // It takes the system a while to find that much memory: who waits sees a slice meanwhile.
    const auto decodeMiddle = [&]() -> Result<Stored> {
        Stored stored(sliceSize(wanted));
        const Result<void> decoded = files.decode(wanted.slices[middle], stored);
        if (!decoded)
            return tl::unexpected<Error>(decoded.error());
        if (!progress.cancelled())
            early(earlySlice(listed, wanted, rescales[middle], stored));
        return stored;
    };
    Result<Stored> firstStored; // written by the task
    std::optional<LoneTask> first;
    if (early && hasWindow(wanted))
        first.emplace([&] { firstStored = decodeMiddle(); });
    resizeInLargePages(loaded.codes, wanted.geometry.voxelCount());
    StoredEncoder encoder(loaded, rescales);
    const auto decode = [&](int k, std::span<std::uint16_t> codes) -> Result<void> {
        if (std::size_t(k) != middle || !first)
            return files.decode(wanted.slices[std::size_t(k)], codes);
        // Not a second time: a slice on which the decoder hangs costs enough.
        first->finish();
        const Result<Stored> stored = std::move(firstStored);
        if (!stored)
            return tl::unexpected<Error>(stored.error());
        std::copy(stored->begin(), stored->end(), codes.begin());
        return {};
    };
    const Errors errors =
        decodeAll(wanted, loaded, progress, decode, [&](int k) { encoder.sliceIsThere(k); });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);

    const auto failures = std::count_if(errors.begin(), errors.end(),
        [](const std::optional<Error>& error) { return error.has_value(); });
    if (failures == std::ptrdiff_t(errors.size()))
        return tl::unexpected<Error>(*errors.front());
    if (failures == 0) {
        loaded.volume = describe(listed, wanted);
        files.report(loaded.volume.problems);
        encoder.finish(hasWindow(wanted));
        return loaded;
    }
    const SliceStack stack = withoutFailed(wanted, loaded.codes, errors);
    loaded.volume = describe(listed, stack);
    files.report(loaded.volume.problems);
    encodeStoredValues(loaded, rescalesOf(stack), hasWindow(stack));
    return loaded;
}

Result<LoadedVolume> loadNumbers(
    const ListedStack& listed, const SliceStack& stack, const Progress& progress)
{
    const Result<std::vector<double>> values = decodeNumbers(stack, progress);
    if (!values)
        return tl::unexpected<Error>(values.error());
    LoadedVolume loaded{.volume = describe(listed, stack)};
    const auto writeSlice = [&](int k, std::span<double> slice) {
        const auto first = values->begin() + std::ptrdiff_t(std::size_t(k) * slice.size());
        std::copy_n(first, slice.size(), slice.begin());
    };
    encodeValues(loaded, writeSlice, hasWindow(stack));
    return loaded;
}

} // namespace

Result<LoadedVolume> loadStack(
    const ListedStack& listed, int time, const Progress& progress, const EarlySliceListener& early)
{
    const SliceStack& wanted =
        time == 0 ? listed.stack : listed.stack.laterTimes.at(std::size_t(time - 1));
    return wanted.slices.front().layout.isWide() ? loadNumbers(listed, wanted, progress)
                                                 : loadStored(listed, wanted, progress, early);
}

} // namespace core
