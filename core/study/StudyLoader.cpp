// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"

#include "core/archive/ArchiveReader.h"
#include "core/archive/UnpackedArchive.h"
#include "core/base/files/ReadableFile.h"
#include "core/dicom/base/DicomFile.h"
#include "core/dicom/stack/DicomScan.h"
#include "core/dicom/stack/StackLoader.h"
#include "core/images/ImagePage.h"
#include "core/images/ImageStack.h"
#include "core/repair/RepairLattice.h"
#include "core/repair/RepairVolume.h"
#include "core/repair/SeriesFindings.h"
#include "core/study/FileFormats.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QSet>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace core {

namespace {

struct SingleFile {
    const FileFormat* format;
    SeriesEntry entry;
};

} // namespace

/// A listing and, beside it, what its entries are made of.
struct Study::Contents {
    StudyListing listing;
    std::vector<ListedStack> stacks;
    std::vector<SingleFile> singles;
    std::vector<SeriesEntry> pictures;

    /// Sorts the stacks, gives them their keys and lists them by study.
    void listStacks();
    void listSingles(const QString& root);
    void listPictures(const QString& root);
    /// Files whose voxels a header beside them tells of are no files that nothing is known of.
    void forgetVoxelFiles();
};

namespace {

constexpr int deepestFolder = 32;

/// Sessions lie beside studies. Opening and closing one as a plain file would take the lock of a
/// session that this process has open (core/sessionfile/database/SessionUse.h).
bool isSession(const QString& file)
{
    return file.endsWith(QLatin1String(".burin")) || file.contains(QLatin1String(".burin-"));
}

Result<QStringList> filesBelow(const QString& path, int mostFiles)
{
    const QFileInfo info(path);
    if (!info.exists())
        return failure(ErrorCode::FileNotFound, path);
    if (!info.isDir())
        return QStringList{info.absoluteFilePath()};
    if (!info.isReadable())
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("permission denied"));
    const QString root = info.absoluteFilePath();
    QStringList files;
    bool sessions = false;
    // Links to folders are not followed: they may lead round in circles.
    QDirIterator iterator(
        root, QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    int seen = 0;
    while (iterator.hasNext()) {
        if (++seen > mostFiles)
            return failure(ErrorCode::TooManyFiles, path, QString::number(mostFiles));
        const QString file = iterator.next();
        if (isSession(iterator.fileName())) {
            sessions = true;
            continue;
        }
        if (file.mid(root.size()).count(QLatin1Char('/')) <= deepestFolder
            && iterator.fileInfo().isFile()) {
            files.append(file);
        }
    }
    if (files.isEmpty() && sessions)
        return failure(ErrorCode::NoImages, path, Clause::saying("only sessions are in it"));
    if (files.isEmpty())
        return failure(ErrorCode::FolderEmpty, path);
    files.sort();
    return files;
}

/// Where a key would name several entries each gets its number.
void numberKeys(std::vector<SeriesEntry*>& entries)
{
    std::map<QString, int> uses;
    for (const SeriesEntry* entry : entries)
        ++uses[entry->key];
    std::map<QString, int> next;
    for (SeriesEntry* entry : entries) {
        if (uses[entry->key] > 1)
            entry->key += QStringLiteral("#%1").arg(++next[entry->key]);
    }
}

Error nothingFound(const StudyListing& listing)
{
    // Files that nothing could be made of explain themselves best.
    const auto telling = std::find_if(
        listing.unreadable.begin(), listing.unreadable.end(), [](const UnreadableFile& file) {
            return file.error.arguments.value(1) != ofNoKnownFormat();
        });
    if (listing.unreadable.size() == 1 && listing.foreign.empty())
        return listing.unreadable.front().error;
    if (telling != listing.unreadable.end())
        return telling->error;
    std::vector<Clause> reasons;
    for (const ForeignObject& object : listing.foreign) {
        const Clause text = object.reason.isEmpty()
            ? object.kind
            : Clause::saying("%1 (%2)", object.kind, object.reason);
        if (std::find(reasons.begin(), reasons.end(), text) == reasons.end())
            reasons.push_back(text);
    }
    Clause all;
    for (const Clause& reason : reasons)
        all = all.isEmpty() ? reason : Clause::saying("%1; %2", all, reason);
    return {ErrorCode::NoImages, {listing.path, all}};
}

/// A file of an unpacked archive as lying in the archive.
void nameWithin(const QString& archive, const QString& unpacked, UnreadableFile& file)
{
    const auto within = [&](const QString& name) {
        return name.startsWith(unpacked) ? archive + name.mid(unpacked.size()) : name;
    };
    file.file = within(file.file);
    file.error.arguments.set(0, within(file.error.arguments.value(0)));
}

Result<const SeriesEntry*> choose(const StudyListing& listing, const QString& series)
{
    const std::vector<const SeriesEntry*> found =
        series.isEmpty() ? listing.candidates() : listing.matching(series);
    if (found.empty() && series.isEmpty())
        return tl::unexpected<Error>(nothingFound(listing));
    if (found.empty())
        return failure(ErrorCode::SeriesNotFound, listing.path, series);
    if (found.size() == 1)
        return found.front();
    Error ambiguous{ErrorCode::SeriesAmbiguous, {listing.path}};
    for (const SeriesEntry* entry : found)
        ambiguous.arguments.append(entry->line());
    return tl::unexpected<Error>(ambiguous);
}

Result<LoadedVolume> loadRepaired(
    const ListedStack& listed, const SeriesChoice& wanted, const Progress& progress)
{
    Clause why;
    const std::optional<SeriesRepair> repair = SeriesRepair::fromText(wanted.repair, &why);
    const auto invalid = [](const Clause& reason) {
        return failure(ErrorCode::InvalidField, QStringLiteral("repair"), reason);
    };
    if (!repair)
        return invalid(why);
    if (repair->givenSpacingMm)
        return invalid(Clause::saying("the series itself says how far apart its voxels are"));
    using Duplicates = SeriesRepair::Duplicates;
    if (repair->duplicates == Duplicates::Keep) {
        Result<LoadedVolume> loaded = loadStack(listed, wanted.time, progress);
        return loaded ? repairVolume(*std::move(loaded), *repair, progress) : loaded;
    }
    if (!listed.stack.doubled)
        return invalid(Clause::saying("the series has no places at which one of several images "
                                      "could be chosen (%1)",
            wanted.repair));
    const ListedStack chosen{.entry = listed.entry,
        .seriesKey = listed.seriesKey,
        .studyKey = listed.studyKey,
        .stack = oneAtEveryPlace(listed.stack, repair->duplicates == Duplicates::Last)};
    Result<LoadedVolume> loaded = loadStack(chosen, 0, progress);
    return loaded ? repairVolume(*std::move(loaded), *repair, progress) : loaded;
}

/// Pictures, with the spacing that is given for them.
Result<LoadedVolume> loadPictures(
    const SeriesEntry& entry, const SeriesChoice& wanted, const Progress& progress)
{
    Clause why;
    const std::optional<SeriesRepair> repair = SeriesRepair::fromText(wanted.repair, &why);
    if (repair && !repair->withoutSpacing().isNone())
        why = Clause::saying("only DICOM series can be repaired; of pictures the spacing can be "
                             "given");
    if (!why.isEmpty())
        return failure(ErrorCode::InvalidField, QStringLiteral("repair"), why);
    if (entry.needsSpacing() && repair->isNone())
        return failure(ErrorCode::InvalidGeometry, stackPath(entry),
            Clause::saying("pictures do not say how far apart their voxels are; --spacing gives "
                           "it in mm: COLUMNS,ROWS,SLICES"));
    SeriesEntry placed = entry;
    placed.geometry = repairedGeometry(entry.geometry, *repair);
    for (VolumeProblem& problem : placed.problems) {
        if (problem.kind != VolumeProblem::Kind::AssumedSpacing || repair->isNone())
            continue;
        problem.repairedBy = repair->toText();
        problem.caution = false;
    }
    Result<LoadedVolume> loaded = loadImageStack(placed, progress);
    if (loaded)
        loaded->volume.repair = repair->toText();
    return loaded;
}

} // namespace

void Study::Contents::listStacks()
{
    const auto order = [](const ListedStack& stack) {
        const StudyIdentity& of = stack.entry.identity;
        return std::make_tuple(of.studyDate, stack.studyKey, of.seriesNumber.toInt(),
            stack.seriesKey, -stack.entry.slices());
    };
    std::stable_sort(stacks.begin(), stacks.end(),
        [&](const ListedStack& a, const ListedStack& b) { return order(a) < order(b); });
    std::vector<SeriesEntry*> entries;
    for (ListedStack& listed : stacks) {
        listed.entry.key = listed.seriesKey;
        entries.push_back(&listed.entry);
    }
    numberKeys(entries);
    for (const ListedStack& listed : stacks) {
        std::vector<StudyEntry>& studies = listing.studies;
        if (studies.empty() || studies.back().studyUid != listed.studyKey)
            studies.push_back({.studyUid = listed.studyKey});
        studies.back().series.push_back(listed.entry);
    }
}

void Study::Contents::listSingles(const QString& root)
{
    const bool besideDicom = !stacks.empty();
    std::vector<SingleFile> volumes;
    for (SingleFile& single : singles) {
        const QString file = single.entry.files.front();
        if (besideDicom) {
            listing.foreign.push_back(
                {.kind = Clause::saying("%1 file", QLatin1String(single.format->name)),
                    .reason = Clause::saying("beside a DICOM study; open it by its own name"),
                    .files = single.entry.files});
            continue;
        }
        single.entry.key = QFileInfo(root).isDir() ? QDir(root).relativeFilePath(file)
                                                   : QFileInfo(file).fileName();
        volumes.push_back(std::move(single));
    }
    singles = std::move(volumes);
    if (singles.empty())
        return;
    StudyEntry study;
    for (const SingleFile& single : singles)
        study.series.push_back(single.entry);
    listing.studies.push_back(std::move(study));
}

void Study::Contents::listPictures(const QString& root)
{
    // Beside a volume they are views of it, or of something else, and seldom one of their own.
    if (!listing.studies.empty()) {
        for (const SeriesEntry& entry : pictures) {
            listing.foreign.push_back({.kind = Clause::saying("picture (PNG or TIFF)"),
                .reason = Clause::saying("beside other volumes; open it by its own name"),
                .files = entry.files});
        }
        pictures.clear();
    }
    if (pictures.empty())
        return;
    std::vector<SeriesEntry*> entries;
    for (SeriesEntry& entry : pictures) {
        const QString path = stackPath(entry);
        // An archive is not named as the cache names it.
        entry.key = QFileInfo(path == root ? listing.path : path).fileName();
        entries.push_back(&entry);
    }
    numberKeys(entries);
    listing.studies.push_back({.studyUid = {}, .series = pictures});
}

void Study::Contents::forgetVoxelFiles()
{
    QSet<QString> voxelFiles;
    for (const SingleFile& single : singles) {
        for (const QString& file : single.entry.files.mid(1))
            voxelFiles.insert(file);
    }
    if (voxelFiles.isEmpty())
        return;
    std::erase_if(listing.unreadable,
        [&](const UnreadableFile& unreadable) { return voxelFiles.contains(unreadable.file); });
    for (SingleFile& single : singles)
        single.entry.files.resize(1);
}

Study::Study(std::unique_ptr<const Contents> contents)
    : m_contents(std::move(contents))
{
}

Study::Study(Study&&) noexcept = default;
Study& Study::operator=(Study&&) noexcept = default;
Study::~Study() = default;

const StudyListing& Study::listing() const
{
    return m_contents->listing;
}

Result<Study> Study::scan(const QString& path, const Progress& progress, int mostFiles)
{
    if (const Result<void> readable = checkReadsToAnEnd(path); !readable)
        return tl::unexpected<Error>(readable.error());
    const QFileInfo info(path);
    const bool isDirectoryFile = info.isFile()
        && info.fileName().compare(QLatin1String("DICOMDIR"), Qt::CaseInsensitive) == 0;
    QString root = isDirectoryFile ? info.absolutePath() : path;
    const bool isUnpacked = isArchive(path);
    if (isUnpacked) {
        Result<QString> unpacked = unpackedArchive(path, progress);
        if (!unpacked)
            return tl::unexpected<Error>(unpacked.error());
        root = *std::move(unpacked);
    }
    Result<QStringList> files = filesBelow(root, mostFiles);
    if (!files && isUnpacked)
        files.error().arguments.set(0, path);
    if (!files)
        return tl::unexpected<Error>(files.error());
    auto contents = std::make_unique<Contents>();
    StudyListing& listing = contents->listing;
    listing.path = path;
    QStringList others;
    QStringList pictures;
    for (const QString& file : *files) {
        if (isImageName(file)) {
            pictures.append(file);
            continue;
        }
        const FileFormat* format = fileFormatOf(file);
        if (format == nullptr) {
            others.append(file);
            continue;
        }
        Result<SeriesEntry> entry = format->read(file);
        if (entry)
            contents->singles.push_back({format, std::move(*entry)});
        else
            listing.unreadable.push_back({.file = file, .error = entry.error()});
    }
    FoundStacks stacks = findImageStacks(pictures, progress);
    DicomScan dicom = scanDicom(others + stacks.others, progress);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    contents->stacks = std::move(dicom.stacks);
    contents->pictures = std::move(stacks.entries);
    listing.unreadable.insert(
        listing.unreadable.end(), stacks.unreadable.begin(), stacks.unreadable.end());
    listing.foreign = std::move(dicom.foreign);
    listing.unreadable.insert(
        listing.unreadable.end(), dicom.unreadable.begin(), dicom.unreadable.end());
    contents->listStacks();
    contents->forgetVoxelFiles();
    if (isUnpacked) {
        for (UnreadableFile& file : listing.unreadable)
            nameWithin(path, root, file);
    }
    contents->listSingles(root);
    contents->listPictures(root);
    if (listing.studies.empty() && listing.foreign.empty())
        return tl::unexpected<Error>(nothingFound(listing));
    return Study(std::move(contents));
}

Result<LoadedVolume> Study::load(
    const QString& series, const Progress& progress, const EarlySliceListener& early) const
{
    const StudyListing& listing = m_contents->listing;
    const SeriesChoice wanted = listing.choice(series);
    const Result<const SeriesEntry*> entry = choose(listing, wanted.series);
    if (!entry)
        return tl::unexpected<Error>(entry.error());
    // @param key of its other points, where it is opened again from there
    const auto opened = [&](Result<LoadedVolume> loaded, const QString& from, const QString& key) {
        if (loaded) {
            loaded->volume.sourcePath = from;
            loaded->volume.seriesKey = (*entry)->keyAtTime(wanted.time);
            SeriesAlternatives alternatives = seriesAlternatives(listing, **entry, wanted.time);
            alternatives.key = key;
            loaded->volume.alternatives =
                std::make_shared<const SeriesAlternatives>(std::move(alternatives));
        } else if (Error& error = loaded.error(); error.code == ErrorCode::InvalidField) {
            // Of a repair that is not possible: whose.
            error.arguments = {error.arguments.value(0), error.arguments.value(1), from};
        }
        return loaded;
    };
    for (const ListedStack& listed : m_contents->stacks) {
        if (listed.entry.key == (*entry)->key)
            return opened(wanted.repair.isEmpty() ? loadStack(listed, wanted.time, progress, early)
                                                  : loadRepaired(listed, wanted, progress),
                listing.path, (*entry)->key);
    }
    for (const SeriesEntry& pictures : m_contents->pictures) {
        if (pictures.key == (*entry)->key)
            return opened(
                loadPictures(pictures, wanted, progress), stackPath(pictures), (*entry)->key);
    }
    if (!wanted.repair.isEmpty())
        return failure(ErrorCode::InvalidField, QStringLiteral("repair"),
            Clause::saying("only DICOM series can be repaired"), listing.path);
    for (const SingleFile& single : m_contents->singles) {
        // Without slices that name it, only this tells an export's check which file it was.
        const QString file = single.entry.files.front();
        if (single.entry.key == (*entry)->key)
            return opened(single.format->load(single.entry, wanted.time, progress), file,
                QFileInfo(file).fileName());
    }
    return failure(ErrorCode::SeriesNotFound, listing.path, series);
}

Result<StudyListing> scanStudies(const QString& path, const Progress& progress)
{
    const Result<Study> study = Study::scan(path, progress);
    if (!study)
        return tl::unexpected<Error>(study.error());
    return study->listing();
}

Result<LoadedVolume> loadVolume(
    const QString& path, const QString& series, const Progress& progress)
{
    const Result<Study> study = Study::scan(path, progress);
    if (!study)
        return tl::unexpected<Error>(study.error());
    return study->load(series, progress);
}

} // namespace core
