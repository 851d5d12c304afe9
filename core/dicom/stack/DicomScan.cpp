// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/DicomScan.h"

#include "core/base/ParallelFor.h"
#include "core/base/StepCounter.h"
#include "core/dicom/codecs/FrameDecoder.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/dicom/items/SopClass.h"

#include <QCryptographicHash>

#include <algorithm>
#include <map>
#include <optional>

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

/// Of PET images in g/ml. Any other kind of uptake has another unit, or none that is known.
QString uptakeUnit(const QString& suvType)
{
    if (suvType.isEmpty() || suvType == QLatin1String("BW"))
        return QStringLiteral("SUVbw");
    // Lean body mass, by whatever formula.
    if (suvType == QLatin1String("LBM") || suvType == QLatin1String("LBMJAMES128")
        || suvType == QLatin1String("LBMJANMA"))
        return QStringLiteral("SUVlbm");
    return suvType == QLatin1String("IBW") ? QStringLiteral("SUVibw") : QStringLiteral("g/mL");
}

QString unitOf(const ImageHeader& image)
{
    const QString& modality = image.identity.modality;
    if (modality == QLatin1String("CT")) {
        const bool hounsfield = image.hasRescale
            && (image.rescaleType.isEmpty() || image.rescaleType == QLatin1String("HU"));
        return hounsfield ? QStringLiteral("HU") : QString();
    }
    if (modality == QLatin1String("RTDOSE"))
        return image.units == QLatin1String("GY") ? QStringLiteral("Gy") : QString();
    if (modality != QLatin1String("PT"))
        return {};
    if (image.units == QLatin1String("BQML"))
        return QStringLiteral("Bq/mL");
    if (image.units == QLatin1String("GML"))
        return uptakeUnit(image.suvType);
    if (image.units == QLatin1String("CM2ML"))
        return QStringLiteral("SUVbsa");
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
    if (stack.doubled)
        result.entry.undoubled = oneAtEveryPlace(stack, false).geometry;
    result.stack = std::move(stack);
    return result;
}

/// Lists what is no slice, or cannot be decoded. @return whether the file's images may be slices
bool takeFile(const std::vector<ImageHeader>& images, DicomScan& scan)
{
    const ImageHeader& first = images.front();
    if (const Clause kind = kindWithoutSlices(first); !kind.isEmpty()) {
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
    if (const Clause reason = undecodableReason(first); !reason.isEmpty()) {
        scan.unreadable.push_back(
            {.file = first.file, .error = {ErrorCode::UnsupportedFormat, {first.file, reason}}});
        return false;
    }
    const bool cut = std::any_of(
        images.begin(), images.end(), [](const ImageHeader& image) { return image.pixelsCut; });
    if (cut) {
        scan.unreadable.push_back({.file = first.file,
            .error = {ErrorCode::FileTruncated,
                {first.file, Clause::saying("its pixel data are incomplete")}}});
    }
    return true;
}

} // namespace

DicomScan scanDicom(const QStringList& files, const Progress& progress)
{
    std::vector<std::optional<Result<std::vector<ImageHeader>>>> headers(std::size_t(files.size()));
    StepCounter counter(progress, ProgressStep::ReadingHeaders, int(files.size()));
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

} // namespace core
