// SPDX-License-Identifier: Apache-2.0
#include "core/images/ImageStack.h"

#include "core/base/ParallelFor.h"
#include "core/images/ImagePage.h"
#include "core/images/NaturalOrder.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <map>
#include <utility>

namespace core {

namespace {

using Pages = Result<std::vector<ImagePage>>;

struct ImageFile {
    QString path;
    FirstBytes begins = FirstBytes::Other;
    Pages pages;
};

std::vector<ImageFile> readFiles(const QStringList& files, const Progress& progress)
{
    std::vector<ImageFile> read(
        std::size_t(files.size()), ImageFile{.pages = failure(ErrorCode::Cancelled)});
    parallelFor(int(files.size()), [&](int index) {
        if (progress.cancelled())
            return;
        ImageFile& file = read[std::size_t(index)];
        file.path = files[index];
        file.begins = firstBytesOf(file.path);
        file.pages = readImagePages(file.path);
    });
    return read;
}

VolumeGeometry geometryOf(const ImagePage& page, std::size_t slices)
{
    VolumeGeometry geometry;
    geometry.size = {page.columns, page.rows, int(slices)};
    for (int axis = 0; axis < 3; ++axis)
        geometry.indexToWorld[axis][axis] = page.spacingMm[axis] > 0.0 ? page.spacingMm[axis] : 1.0;
    return geometry;
}

QString millimetres(double value)
{
    return QString::number(value, 'g', 6);
}

/// What is not known of any such stack, or not said by its files.
void addProblemsOfAll(SeriesEntry& entry)
{
    const glm::dvec3 said = *entry.saidSpacingMm;
    ProblemSentence distance{ProblemCode::PicturesWithoutSpacing};
    if (said.x > 0.0 && said.z <= 0.0)
        distance = {
            ProblemCode::PicturesWithoutDistance, {millimetres(said.x), millimetres(said.y)}};
    if (entry.needsSpacing())
        entry.problems.push_back(
            {.kind = VolumeProblem::Kind::AssumedSpacing, .said = distance, .caution = true});
    entry.problems.push_back({.kind = VolumeProblem::Kind::Other,
        .said = {ProblemCode::PicturesWithoutAxes},
        .caution = true});
}

SeriesEntry entryOf(const ImagePage& page, std::size_t slices, const QStringList& files)
{
    SeriesEntry entry;
    entry.geometry = geometryOf(page, slices);
    entry.saidSpacingMm = page.spacingMm;
    entry.files = files;
    addProblemsOfAll(entry);
    if (!page.isUpright)
        entry.problems.push_back(
            {.kind = VolumeProblem::Kind::Other, .said = {ProblemCode::PicturesTurned}});
    entry.identity.seriesDescription = QFileInfo(stackPath(entry)).fileName();
    return entry;
}

tl::unexpected<Error> differs(const ImagePage& page, const ImagePage& first)
{
    return failure(ErrorCode::UnsupportedFormat, page.file,
        Clause::saying("it is %1, but %2 is %3; the slices of a volume are alike", page.inWords(),
            QFileInfo(first.file).fileName(), first.inWords()));
}

Result<SeriesEntry> stackOfPages(const ImageFile& file)
{
    const std::vector<ImagePage>& pages = *file.pages;
    if (pages.size() > std::size_t(longestImageSide))
        return failure(
            ErrorCode::InvalidGeometry, file.path, Clause::saying("%1 pictures", pages.size()));
    for (std::size_t page = 1; page < pages.size(); ++page) {
        if (!pages[page].isLike(pages.front()))
            return failure(ErrorCode::UnsupportedFormat, file.path,
                Clause::saying("its picture %1 is %2, but the first is %3; the slices of a volume "
                               "are alike",
                    page + 1, pages[page].inWords(), pages.front().inWords()));
    }
    return entryOf(pages.front(), pages.size(), {file.path});
}

void addGaps(SeriesEntry& entry)
{
    QStringList names;
    for (const QString& file : std::as_const(entry.files))
        names.append(QFileInfo(file).fileName());
    const std::vector<NumberGap> gaps = numberGaps(names);
    if (gaps.empty())
        return;
    VolumeProblem problem{.kind = VolumeProblem::Kind::MissingSlices, .caution = true};
    std::vector<ProblemSentence> places;
    for (const NumberGap& gap : gaps) {
        problem.slices.push_back({.first = gap.after + 1, .last = gap.after + 2});
        places.push_back({ProblemCode::NumbersMissingBetween,
            {gap.missing, names[gap.after], names[gap.after + 1]}});
    }
    constexpr std::size_t mostPlaces = 5;
    if (const std::size_t all = places.size(); all > mostPlaces) {
        places.resize(mostPlaces);
        places.push_back({ProblemCode::AtMorePlaces, {std::int64_t(all - mostPlaces)}});
    }
    problem.said = {ProblemCode::NumbersMissing, {withCommas(std::move(places))}};
    entry.problems.push_back(std::move(problem));
}

/// The single pictures of one folder, in any order. @pre one of them can be read
Result<SeriesEntry> stackOfFolder(std::vector<const ImageFile*> files)
{
    std::sort(files.begin(), files.end(), [](const ImageFile* a, const ImageFile* b) {
        return comesBefore(QFileInfo(a->path).fileName(), QFileInfo(b->path).fileName());
    });
    if (files.size() > std::size_t(longestImageSide))
        return failure(ErrorCode::InvalidGeometry, QFileInfo(files.front()->path).path(),
            Clause::saying("%1 pictures", files.size()));
    const ImagePage* first = nullptr;
    QStringList paths;
    for (const ImageFile* file : files) {
        paths.append(file->path);
        // What is no slice for good reason is not left empty.
        if (!file->pages && file->pages.error().code == ErrorCode::UnsupportedFormat)
            return tl::unexpected<Error>(file->pages.error());
        if (!file->pages)
            continue;
        const ImagePage& page = file->pages->front();
        if (first == nullptr)
            first = &page;
        else if (!page.isLike(*first))
            return differs(page, *first);
    }
    SeriesEntry entry = entryOf(*first, files.size(), paths);
    addGaps(entry);
    return entry;
}

void take(FoundStacks& found, Result<SeriesEntry> entry)
{
    if (entry)
        found.entries.push_back(*std::move(entry));
    else
        found.unreadable.push_back(
            {.file = entry.error().arguments.value(0), .error = entry.error()});
}

/// The files of one folder.
void findInFolder(const std::vector<const ImageFile*>& files, FoundStacks& found)
{
    std::vector<const ImageFile*> single;
    bool anySound = false;
    for (const ImageFile* file : files) {
        if (file->pages && file->pages->size() > 1) {
            take(found, stackOfPages(*file));
            continue;
        }
        anySound = anySound || file->pages.has_value();
        single.push_back(file);
    }
    if (anySound) {
        take(found, stackOfFolder(single));
        return;
    }
    for (const ImageFile* file : single) {
        if (file->begins == FirstBytes::Image)
            found.unreadable.push_back({.file = file->path, .error = file->pages.error()});
        else
            found.others.append(file->path);
    }
}

QString key(const char* name)
{
    return QLatin1String(name);
}

} // namespace

FoundStacks findImageStacks(const QStringList& files, const Progress& progress)
{
    FoundStacks found;
    const std::vector<ImageFile> read = readFiles(files, progress);
    if (progress.cancelled())
        return found;
    std::map<QString, std::vector<const ImageFile*>> folders;
    for (const ImageFile& file : read) {
        if (file.begins == FirstBytes::Dicom)
            found.others.append(file.path);
        else
            folders[QFileInfo(file.path).path()].push_back(&file);
    }
    for (const auto& [folder, inside] : folders)
        findInFolder(inside, found);
    return found;
}

QString stackPath(const SeriesEntry& entry)
{
    const QString first = entry.files.value(0);
    return entry.files.size() == 1 ? first : QFileInfo(first).path();
}

QByteArray imageStackHeader(const QString& path)
{
    QStringList files{path};
    if (QFileInfo(path).isDir()) {
        files.clear();
        for (const QFileInfo& file : QDir(path).entryInfoList(QDir::Files | QDir::Hidden)) {
            if (isImageName(file.filePath()))
                files.append(file.filePath());
        }
    }
    const FoundStacks found = findImageStacks(files, Progress());
    for (const SeriesEntry& entry : found.entries) {
        if (stackPath(entry) != path)
            continue;
        const glm::ivec3 size = entry.geometry.size;
        const glm::dvec3 said = *entry.saidSpacingMm;
        return QJsonDocument(QJsonObject{{key("size"), QJsonArray{size.x, size.y, size.z}},
                                 {key("saidSpacingMm"), QJsonArray{said.x, said.y, said.z}}})
            .toJson(QJsonDocument::Compact);
    }
    return {};
}

Result<VolumeGeometry> imageStackGeometryOf(const QByteArray& header, const QString& path)
{
    const QJsonObject json = QJsonDocument::fromJson(header).object();
    const QJsonArray size = json[key("size")].toArray();
    const QJsonArray said = json[key("saidSpacingMm")].toArray();
    ImagePage page{.file = path, .columns = size[0].toInt(), .rows = size[1].toInt()};
    for (int axis = 0; axis < 3; ++axis)
        page.spacingMm[axis] = said[axis].toDouble();
    const int slices = size[2].toInt();
    if (page.columns < 1 || page.rows < 1 || slices < 1)
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("its pictures are gone"));
    return geometryOf(page, std::size_t(slices));
}

} // namespace core
