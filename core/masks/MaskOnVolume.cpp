// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOnVolume.h"

#include "core/base/files/ReadableFile.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/dicom/items/SopClass.h"
#include "core/masks/MaskParts.h"
#include "core/meshfile/MeshReader.h"
#include "core/metaimage/MetaImageReader.h"
#include "core/nifti/NiftiReader.h"
#include "core/nrrd/NrrdReader.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace core {

namespace {

constexpr const char* rtStructClass = "1.2.840.10008.5.1.4.1.1.481.3";

} // namespace

QString maskNameOf(const QString& path)
{
    QString name = QFileInfo(path).fileName();
    for (const QString& pattern : maskNamePatterns()) {
        const QString ending = pattern.mid(1);
        if (name.endsWith(ending, Qt::CaseInsensitive)) {
            name.chop(ending.size());
            break;
        }
    }
    name = name.simplified();
    return name.isEmpty() ? QStringLiteral("Mask") : name;
}

double millilitres(std::uint64_t voxels, const VolumeGeometry& geometry)
{
    return double(voxels) * geometry.voxelVolumeMm3() / 1000.0;
}

std::vector<MaskNote> notesOn(const MaskFit& fit)
{
    std::vector<MaskNote> notes;
    if (!fit.oneToOne)
        notes.push_back(
            {.code = MaskNote::Code::AnotherGrid, .fileMl = fit.labelledMl, .hereMl = fit.takenMl});
    if (fit.outside != 0)
        notes.push_back(
            {.code = MaskNote::Code::OutsideStudy, .some = fit.outside, .all = fit.labelled});
    return notes;
}

std::vector<MaskNote> notesOnOrigin(
    const QString& patientId, const QString& frameOfReferenceUid, const Volume& volume)
{
    const auto differ = [](const QString& one, const QString& other) {
        return !one.isEmpty() && !other.isEmpty() && one != other;
    };
    std::vector<MaskNote> notes;
    if (differ(patientId, volume.identity.patientId))
        notes.push_back({.code = MaskNote::Code::AnotherPatient});
    if (differ(frameOfReferenceUid, volume.identity.frameOfReferenceUid))
        notes.push_back({.code = MaskNote::Code::AnotherFrameOfReference});
    return notes;
}

tl::unexpected<Error> hasNoLabel(const QString& path)
{
    return failure(ErrorCode::UnsupportedFormat, path, Clause::saying("it has no label"));
}

tl::unexpected<Error> holdsNoLabels(const QString& path, double value)
{
    return failure(ErrorCode::UnsupportedFormat, path,
        Clause::saying("its values are not labels: %1 is among them", value));
}

tl::unexpected<Error> holdsImage(const QString& path)
{
    return failure(ErrorCode::UnsupportedFormat, path,
        Clause::saying("its values are those of an image and no labels"));
}

tl::unexpected<Error> holdsTooManyLabels(const QString& path)
{
    return failure(ErrorCode::UnsupportedFormat, path,
        Clause::saying("it holds more than %1 labels", mostSegments));
}

QStringList maskFilesIn(const QString& path)
{
    QStringList files;
    const QDir folder(path);
    for (const QString& name : folder.entryList(maskNamePatterns(), QDir::Files, QDir::Name))
        files.append(folder.filePath(name));
    return files;
}

namespace {

/// Whether two failures differ at most in the file and the numbers that they name.
bool isAlike(const Error& one, const Error& other)
{
    return one.code == other.code
        && qstrcmp(one.arguments.value(1).form(), other.arguments.value(1).form()) == 0;
}

bool saysNoLabel(const Error& error)
{
    return isAlike(error, hasNoLabel({}).value());
}

tl::unexpected<Error> holdsSlices(const QString& path)
{
    return failure(ErrorCode::UnsupportedFormat, path,
        Clause::saying("its DICOM files are images and no masks"));
}

bool isLabelMapName(const QString& path)
{
    return isNiftiName(path) || isNrrdName(path) || isMetaImageName(path);
}

/// Whether it is an image in DICOM, such as a slice. What is neither that nor a mask is refused by
/// its reader.
bool isDicomImage(const QString& path)
{
    if (isLabelMapName(path) || isMeshName(path))
        return false;
    const Result<ImageHeader> header = readImageHeader(path);
    return header && !header->sopClassUid.isEmpty() && kindWithoutSlices(*header).isEmpty();
}

/// One file; without a segment if it lies wholly outside the study.
Result<MaskOnVolume> readFile(const QString& path, const Volume& volume, const Progress& progress)
{
    if (const Result<void> isFile = checkIsFile(path); !isFile)
        return tl::unexpected(isFile.error());
    auto read = readLabelMask;
    if (isMeshName(path)) {
        read = readSurfaceMask;
    } else if (!isLabelMapName(path)) {
        const Result<QString> sopClass = sopClassOf(path);
        if (!sopClass)
            return tl::unexpected(sopClass.error());
        read = *sopClass == QLatin1String(rtStructClass) ? readContourMask : readSegMask;
    }
    return read(path, volume, progress);
}

/// Adds a note of one file of a folder: notes of a kind become one, unless they name segments.
void addNote(std::vector<MaskNote>& notes, const MaskNote& note)
{
    const auto same = std::find_if(notes.begin(), notes.end(), [&note](const MaskNote& known) {
        return known.code == note.code && known.names.isEmpty() && note.names.isEmpty()
            && known.doubt == note.doubt;
    });
    if (same == notes.end()) {
        notes.push_back(note);
        return;
    }
    same->some += note.some;
    same->all += note.all;
    same->fileMl += note.fileMl;
    same->hereMl += note.hereMl;
    same->mm = std::max(same->mm, note.mm);
}

Result<MaskOnVolume> readFolder(const QString& path, const Volume& volume, const Progress& progress)
{
    const QStringList files = maskFilesIn(path);
    if (files.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("no mask file lies in this folder (%1)", maskNamePatterns().join(u' ')));
    MaskOnVolume mask;
    std::uint64_t empty = 0;
    QStringList images; ///< that could have been masks by their names
    std::uint64_t slices = 0;
    std::optional<Error> whyNoMask;
    for (int i = 0; i < files.size(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::PlacingMask, i, int(files.size()));
        if (isDicomImage(files[i])) {
            ++slices;
            continue;
        }
        Result<MaskOnVolume> one = readFile(files[i], volume, progress);
        if (!one && saysImage(one.error())) {
            images.append(QFileInfo(files[i]).fileName());
            if (!whyNoMask)
                whyNoMask = one.error();
            continue;
        }
        if (!one && !saysNoLabel(one.error()))
            return one;
        if (!one || one->segments.empty()) {
            ++empty;
            continue;
        }
        std::move(one->segments.begin(), one->segments.end(), std::back_inserter(mask.segments));
        if (mask.segments.size() > mostSegments)
            return failure(ErrorCode::UnsupportedFormat, path,
                Clause::saying("its files hold more than %1 segments", mostSegments));
        for (const MaskNote& note : one->notes)
            addNote(mask.notes, note);
    }
    if (mask.segments.empty() && whyNoMask)
        return tl::unexpected(*whyNoMask);
    if (slices == std::uint64_t(files.size()))
        return holdsSlices(path);
    if (!images.isEmpty())
        mask.notes.push_back({.code = MaskNote::Code::ImagesLeftOut, .names = images});
    if (slices > 0)
        mask.notes.push_back({.code = MaskNote::Code::SlicesLeftOut, .some = slices});
    if (empty > 0 && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::FilesWithoutVoxel,
            .some = empty,
            .all = std::uint64_t(files.size())});
    return mask;
}

} // namespace

bool saysImage(const Error& error)
{
    return isAlike(error, holdsImage({}).value()) || isAlike(error, holdsTooManyLabels({}).value())
        || isAlike(error, holdsSlices({}).value());
}

Result<MaskOnVolume> readMask(const QString& path, const Volume& volume, const Progress& progress)
{
    Result<MaskOnVolume> mask = QFileInfo(path).isDir() ? readFolder(path, volume, progress)
                                                        : readFile(path, volume, progress);
    if (!mask)
        return mask;
    if (mask->segments.empty())
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("it lies wholly outside the study"));
    mask->overlaps = overlapsOf(mask->segments);
    if (!mask->overlaps.empty())
        mask->notes.push_back(
            {.code = MaskNote::Code::SegmentsOverlap, .some = voxelsOf(mask->overlaps)});
    return mask;
}

bool isMaskClass(const QString& sopClassUid)
{
    return sopClassUid == QLatin1String(rtStructClass)
        || sopClassUid == QLatin1String("1.2.840.10008.5.1.4.1.1.66.4") // Segmentation
        || sopClassUid == QLatin1String("1.2.840.10008.5.1.4.1.1.66.7"); // Label Map Segmentation
}

QStringList maskNamePatterns()
{
    // The longer one first of those that end alike.
    return {QStringLiteral("*.nii.gz"), QStringLiteral("*.nii"), QStringLiteral("*.seg.nrrd"),
        QStringLiteral("*.nrrd"), QStringLiteral("*.nhdr"), QStringLiteral("*.mha"),
        QStringLiteral("*.mhd"), QStringLiteral("*.stl"), QStringLiteral("*.obj"),
        QStringLiteral("*.ply"), QStringLiteral("*.glb"), QStringLiteral("*.dcm")};
}

} // namespace core
