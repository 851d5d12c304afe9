// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/DicomScan.h"

#include "core/base/ParallelFor.h"
#include "core/dicom/FrameDecoder.h"
#include "core/dicom/ImageHeaderReader.h"
#include "core/dicom/SopClass.h"
#include "core/dicom/StackGeometry.h"
#include "core/volume/MemoryLimit.h"
#include "core/volume/VolumeEncoder.h"

#include <QCryptographicHash>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

namespace core {

namespace {

/// A name for a group of files that carry no UID, the same whenever they are read again.
QString madeUpName(const char* what, const QStringList& facts)
{
    const QByteArray digest =
        QCryptographicHash::hash(facts.join(QChar(0x1f)).toUtf8(), QCryptographicHash::Sha256);
    return QStringLiteral("no-%1-uid-%2")
        .arg(QLatin1String(what), QString::fromLatin1(digest.toHex().left(12)));
}

QString studyKey(const StudyIdentity& of)
{
    if (!of.studyUid.isEmpty())
        return of.studyUid;
    return madeUpName("study",
        {of.patientName, of.patientId, of.birthDate, of.studyDate, of.studyDescription,
            of.accessionNumber});
}

QString seriesKey(const StudyIdentity& of)
{
    if (!of.seriesUid.isEmpty())
        return of.seriesUid;
    return madeUpName("series", {studyKey(of), of.seriesNumber, of.seriesDescription, of.modality});
}

QString unitOf(const ImageHeader& image)
{
    const QString& modality = image.identity.modality;
    if (modality == QLatin1String("CT")) {
        const bool hounsfield = image.hasRescale
            && (image.rescaleType.isEmpty() || image.rescaleType == QLatin1String("HU"));
        return hounsfield ? QStringLiteral("HU") : QString();
    }
    if (modality != QLatin1String("PT"))
        return {};
    if (image.units == QLatin1String("BQML"))
        return QStringLiteral("Bq/mL");
    if (image.units == QLatin1String("GML"))
        return QStringLiteral("g/mL");
    return image.units;
}

ListedStack listed(SliceStack stack)
{
    const ImageHeader& first = stack.slices.front();
    ListedStack result{.entry = {.identity = first.identity,
                           .geometry = stack.geometry,
                           .unit = unitOf(first),
                           .part = stack.part,
                           .problems = stack.problems},
        .seriesKey = seriesKey(first.identity),
        .studyKey = studyKey(first.identity)};
    if (!stack.laterTimes.empty())
        result.entry.times.append(stack.time);
    for (const SliceStack& later : stack.laterTimes)
        result.entry.times.append(later.time);
    for (const ImageHeader& image : stack.slices) {
        result.entry.files.append(image.file);
        // The volume has only what its slices have in common.
        if (image.identity.frameOfReferenceUid != first.identity.frameOfReferenceUid)
            result.entry.identity.frameOfReferenceUid.clear();
    }
    result.stack = std::move(stack);
    return result;
}

/// Counts steps done on several threads; the listener hears them one at a time and in order.
class StepCounter {
public:
    StepCounter(const Progress& progress, const QString& step, int total)
        : m_progress(progress)
        , m_step(step)
        , m_total(total)
    {
    }

    void stepDone()
    {
        const std::lock_guard lock(m_mutex);
        m_progress.report(m_step, ++m_done, m_total);
    }

private:
    const Progress& m_progress;
    const QString m_step;
    const int m_total;
    std::mutex m_mutex;
    int m_done = 0;
};

/// Slots of what is decoded, and what went wrong.
struct Decoding {
    std::vector<std::uint16_t> stored;
    std::vector<std::optional<Error>> errors;
};

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

    [[nodiscard]] Result<void> decode(const ImageHeader& image, std::span<std::uint16_t> stored)
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

private:
    struct Slot {
        std::once_flag once;
        std::optional<Result<FrameFile>> file;
    };
    std::map<QString, std::unique_ptr<Slot>> m_files; ///< does not change while threads look
};

Decoding decodeAll(const SliceStack& stack, const Progress& progress)
{
    const std::size_t size =
        std::size_t(stack.geometry.size.x) * std::size_t(stack.geometry.size.y);
    Decoding decoding;
    decoding.stored.resize(stack.geometry.voxelCount());
    decoding.errors.resize(stack.slices.size());
    SharedFiles files(stack.slices);
    StepCounter counter(progress, QStringLiteral("Reading slices"), int(stack.slices.size()));
    parallelFor(int(stack.slices.size()), [&](int k) {
        if (progress.cancelled())
            return;
        const auto slot = std::size_t(k);
        const Result<void> decoded =
            files.decode(stack.slices[slot], std::span(decoding.stored).subspan(slot * size, size));
        if (!decoded)
            decoding.errors[slot] = decoded.error();
        counter.stepDone();
    });
    return decoding;
}

/// Leaves out the slices that failed; the rest is placed anew.
SliceStack withoutFailed(const SliceStack& stack, Decoding& decoding)
{
    const std::size_t size =
        std::size_t(stack.geometry.size.x) * std::size_t(stack.geometry.size.y);
    std::vector<ImageHeader> sound;
    QStringList failed;
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        if (decoding.errors[k]) {
            failed.append(imageName(stack.slices[k]));
            continue;
        }
        std::copy_n(decoding.stored.begin() + std::ptrdiff_t(k * size), size,
            decoding.stored.begin() + std::ptrdiff_t(sound.size() * size));
        sound.push_back(stack.slices[k]);
    }
    decoding.stored.resize(sound.size() * size);
    SliceStack rest = stackOf(std::move(sound));
    rest.part = stack.part;
    rest.time = stack.time;
    rest.problems.push_back(damagedSlices(failed));
    return rest;
}

/// Lists what is no slice, or cannot be decoded. @return whether the file's images may be slices
bool takeFile(const std::vector<ImageHeader>& images, DicomScan& scan)
{
    const ImageHeader& first = images.front();
    if (const QString kind = kindWithoutSlices(first); !kind.isEmpty()) {
        const auto same = std::find_if(
            scan.foreign.begin(), scan.foreign.end(), [&](const ForeignObject& object) {
                return object.kind == kind && object.identity.seriesUid == first.identity.seriesUid;
            });
        if (same != scan.foreign.end())
            same->files.append(first.file);
        else
            scan.foreign.push_back(
                {.kind = kind, .identity = first.identity, .files = {first.file}});
        return false;
    }
    if (const QString reason = undecodableReason(first); !reason.isEmpty()) {
        scan.unreadable.push_back(
            {.file = first.file, .error = {ErrorCode::UnsupportedFormat, {first.file, reason}}});
        return false;
    }
    const bool cut = std::any_of(
        images.begin(), images.end(), [](const ImageHeader& image) { return image.pixelsCut; });
    if (cut) {
        scan.unreadable.push_back({.file = first.file,
            .error = {ErrorCode::FileTruncated,
                {first.file, QStringLiteral("its pixel data are incomplete")}}});
    }
    return true;
}

} // namespace

DicomScan scanDicom(const QStringList& files, const Progress& progress)
{
    std::vector<std::optional<Result<std::vector<ImageHeader>>>> headers(std::size_t(files.size()));
    StepCounter counter(progress, QStringLiteral("Reading headers"), int(files.size()));
    parallelFor(int(files.size()), [&](int index) {
        if (progress.cancelled())
            return;
        headers[std::size_t(index)] = readImageHeaders(files[index]);
        counter.stepDone();
    });

    DicomScan scan;
    std::map<std::pair<QString, QString>, std::vector<ImageHeader>> series;
    for (std::optional<Result<std::vector<ImageHeader>>>& header : headers) {
        if (!header)
            continue;
        if (!*header) {
            const Error& error = header->error();
            scan.unreadable.push_back({.file = error.arguments.value(0), .error = error});
            continue;
        }
        std::vector<ImageHeader>& images = **header;
        if (!takeFile(images, scan))
            continue;
        std::vector<ImageHeader>& own =
            series[{studyKey(images.front().identity), seriesKey(images.front().identity)}];
        std::move(images.begin(), images.end(), std::back_inserter(own));
    }
    for (auto& [keys, images] : series) {
        StackSorting sorting = sortIntoStacks(std::move(images));
        for (SliceStack& stack : sorting.stacks)
            scan.stacks.push_back(listed(std::move(stack)));
        scan.foreign.insert(scan.foreign.end(), sorting.foreign.begin(), sorting.foreign.end());
    }
    return scan;
}

Result<LoadedVolume> loadStack(const ListedStack& listed, int time, const Progress& progress)
{
    const SliceStack& wanted =
        time == 0 ? listed.stack : listed.stack.laterTimes.at(std::size_t(time - 1));
    if (const Result<void> fits = checkMemory(wanted.geometry.voxelCount()); !fits)
        return tl::unexpected<Error>(fits.error());
    Decoding decoding = decodeAll(wanted, progress);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);

    SliceStack stack{.slices = wanted.slices,
        .geometry = wanted.geometry,
        .problems = wanted.problems,
        .part = wanted.part,
        .time = wanted.time,
        .laterTimes = {}};
    const auto failures = std::count_if(decoding.errors.begin(), decoding.errors.end(),
        [](const std::optional<Error>& error) { return error.has_value(); });
    if (failures == std::ptrdiff_t(stack.slices.size()))
        return tl::unexpected<Error>(*decoding.errors.front());
    if (failures > 0)
        stack = withoutFailed(stack, decoding);

    LoadedVolume loaded;
    Volume& volume = loaded.volume;
    volume.identity = listed.entry.identity;
    volume.geometry = stack.geometry;
    volume.unit = listed.entry.unit;
    volume.sourceFormat = QStringLiteral("DICOM");
    volume.problems = stack.problems;
    const ImageHeader& middle = stack.slices[stack.slices.size() / 2];
    volume.displayInverted = middle.layout.photometric == QLatin1String("MONOCHROME1");
    if (middle.window)
        volume.defaultWindow = *middle.window;
    std::vector<SliceRescale> rescales;
    for (const ImageHeader& image : stack.slices) {
        rescales.push_back({.slope = image.slope,
            .intercept = image.intercept,
            .isSigned = image.layout.isSigned});
        volume.sources.push_back({.file = image.file,
            .sopInstanceUid = image.sopInstanceUid,
            .sopClassUid = image.sopClassUid,
            .frame = image.frame,
            .instanceNumber = image.instanceNumber});
    }
    loaded.codes = std::move(decoding.stored);
    encodeStoredValues(loaded, rescales, middle.window.has_value());
    return loaded;
}

} // namespace core
