// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionStudy.h"

#include "core/repair/RepairLattice.h"
#include "core/sessionfile/records/SessionImages.h"
#include "core/study/StudyLoader.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <vector>

namespace core {

namespace {

/// Whether a path is one that a Burin has written into a session: whole, without detours, and where
/// studies can be. Others would have a stranger's session search the disk or the machine's devices.
bool isOfASession(const QString& path)
{
    const bool whole = path.startsWith(QLatin1Char('/')) && QDir::cleanPath(path) == path
        && !path.split(QLatin1Char('/')).contains(QLatin1String("..")) && path.size() < 4096
        && !path.contains(QChar::Null);
    if (!whole || path == QLatin1String("/"))
        return false;
    const QString first = path.section(QLatin1Char('/'), 1, 1);
    // The whole of what a system itself puts there is nobody's study.
    static constexpr const char* ofTheSystem[]{"bin", "boot", "etc", "home", "lib", "lib32",
        "lib64", "libx32", "media", "mnt", "opt", "root", "sbin", "srv", "tmp", "usr", "var"};
    if (path.count(QLatin1Char('/')) == 1
        && std::any_of(std::begin(ofTheSystem), std::end(ofTheSystem),
            [&first](const char* name) { return first == QLatin1String(name); }))
        return false;
    // Sticks and discs are mounted below /run/media, other computers that a file manager shows
    // below /run/user/1000/gvfs.
    if (first == QLatin1String("run")) {
        static const QRegularExpression mounted(
            QStringLiteral("^/run/(media/|user/[0-9]+/gvfs/.)"));
        return mounted.match(path).hasMatch();
    }
    return first != QLatin1String("proc") && first != QLatin1String("sys")
        && first != QLatin1String("dev");
}

/// The longest end of @p path that exists below @p folder.
QString longestEndIn(const QDir& folder, const QString& path)
{
    const QStringList parts = path.split(QLatin1Char('/'), Qt::SkipEmptyParts);
    for (qsizetype first = 0; first < parts.size(); ++first) {
        const QString found = folder.filePath(parts.mid(first).join(QLatin1Char('/')));
        if (QFileInfo::exists(found))
            return QDir::cleanPath(found);
    }
    return {};
}

/// Whether an entry, repaired as the session's series was, has its size as far as headers tell.
bool mayGive(const SeriesEntry& entry, const SessionSource& source)
{
    const std::optional<SeriesRepair> repair = SeriesRepair::fromText(source.repair);
    if (!repair || repair->isNone())
        return entry.geometry.size == source.size;
    const VolumeGeometry& slices = repair->duplicates != SeriesRepair::Duplicates::Keep
        ? entry.undoubled.value_or(entry.geometry)
        : entry.geometry;
    return repairObstacle(slices, *repair).isEmpty()
        && repairedGeometry(slices, *repair).size == source.size;
}

/// 0-based, the one that a session names (from 1; 0: none) first.
std::vector<int> pointsInTime(const SeriesEntry& entry, int named)
{
    std::vector<int> points(std::max<std::size_t>(1, std::size_t(entry.times.size())));
    std::iota(points.begin(), points.end(), 0);
    if (named > 0 && named <= int(points.size()))
        std::rotate(points.begin(), points.begin() + named - 1, points.begin() + named);
    return points;
}

/// The keys of what may be the session's volume, as far as headers tell.
QStringList keysOf(const StudyListing& listing, const SessionSource& source, const QString& series)
{
    const SeriesChoice choice = listing.choice(series);
    const QString wanted = series.isEmpty() ? source.seriesUid : choice.series;
    QStringList keys;
    for (const StudyEntry& study : listing.studies) {
        for (const SeriesEntry& entry : study.series) {
            // One UID may hold several volumes, of which only the first has it as its key.
            const bool named =
                wanted.isEmpty() || entry.key == wanted || entry.identity.seriesUid == wanted;
            if (!named || !mayGive(entry, source))
                continue;
            // Elsewhere a series may have more or fewer points, and an older session does not say
            // which one it was made on: the others are asked, too, after the one that it names.
            const bool pointIsOpen = series.isEmpty() || choice.series == series;
            for (const int time : pointsInTime(entry, source.time)) {
                if (pointIsOpen || time == choice.time)
                    keys += withRepair(entry.keyAtTime(time), source.repair);
            }
        }
    }
    return keys;
}

/// Who says that the study is there. A stranger's session may name any folder of this machine.
enum class Asked { ByUser, BySession };
constexpr int mostFilesOfASessionsPlace = 20'000;

Result<LoadedVolume> loadFrom(const QString& place, const QString& sessionFile,
    const QString& series, const SessionSource& source, Asked asked, const Progress& progress)
{
    const auto mismatch = [&](const Clause& difference) {
        return failure(ErrorCode::SessionMismatch, sessionFile,
            Clause::saying("of what is in %1, %2", place, difference));
    };
    const int mostFiles =
        asked == Asked::ByUser ? Study::mostFilesScanned : mostFilesOfASessionsPlace;
    const Result<Study> study = Study::scan(place, progress, mostFiles);
    if (!study && study.error().code == ErrorCode::TooManyFiles)
        return mismatch(Clause::saying("more than %1 files are not looked through unless somebody "
                                       "asks for it; name the study's own folder",
            mostFiles));
    if (!study)
        return tl::unexpected(study.error());
    const QStringList keys = keysOf(study->listing(), source, series);
    if (keys.isEmpty())
        return mismatch(Clause::saying(
            "no volume has its series and size (%1; %2 × %3 × %4 voxels)",
            source.seriesUid.isEmpty() ? Clause::saying("no series UID") : Clause(source.seriesUid),
            source.size.x, source.size.y, source.size.z));
    Clause difference;
    for (const QString& key : keys) {
        Result<LoadedVolume> loaded = study->load(key, progress);
        if (!loaded)
            return loaded;
        difference = source.differenceFrom(loaded->volume);
        if (difference.isEmpty())
            return loaded;
    }
    return mismatch(difference);
}

/// What the session holds itself. @param why its study cannot be read
Result<LoadedVolume> imagesInstead(const QString& sessionFile, Error why, const Progress& progress)
{
    Result<LoadedVolume> images = loadSessionImages(sessionFile, progress);
    if (images) {
        images->notFromStudy = why;
        return images;
    }
    if (images.error().code == ErrorCode::Cancelled)
        return images;
    if (images.error().code == ErrorCode::NoImages)
        return tl::unexpected(why);
    const Clause reason = images.error().arguments.value(1);
    if (why.code == ErrorCode::StudyMissing)
        why.arguments.append(reason);
    else
        why.arguments = {why.arguments.value(0),
            Clause::saying(
                "%1; nor can its own images be used: %2", why.arguments.value(1), reason)};
    return tl::unexpected(why);
}

} // namespace

QStringList studyPlaces(const QString& sessionFile, const SessionSource& source)
{
    QStringList places;
    if (!isOfASession(source.path))
        return places;
    QDir folder = QFileInfo(sessionFile).absoluteDir();
    places += QFileInfo::exists(source.path) ? source.path : QString();
    places += longestEndIn(folder, source.path);
    if (folder.cdUp() && !folder.isRoot())
        places += longestEndIn(folder, source.path);
    places.removeAll(QString());
    places.removeDuplicates();
    return places;
}

Result<LoadedVolume> loadSessionStudy(const QString& sessionFile, const SessionSource& source,
    const QString& place, const QString& series, const Progress& progress)
{
    const QStringList places =
        place.isEmpty() ? studyPlaces(sessionFile, source) : QStringList{place};
    std::optional<Error> first;
    for (const QString& candidate : places) {
        Result<LoadedVolume> loaded = loadFrom(candidate, sessionFile, series, source,
            place.isEmpty() ? Asked::BySession : Asked::ByUser, progress);
        if (loaded || loaded.error().code == ErrorCode::Cancelled)
            return loaded;
        if (!first)
            first = loaded.error();
    }
    const Error why = first ? *first : Error{ErrorCode::StudyMissing, {sessionFile, source.path}};
    if (!place.isEmpty() || !series.isEmpty())
        return tl::unexpected(why);
    return imagesInstead(sessionFile, why, progress);
}

} // namespace core
