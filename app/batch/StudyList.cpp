// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyList.h"

#include "core/archive/ArchiveReader.h"
#include "core/base/files/ReadableFile.h"
#include "core/study/FileFormats.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace app {

namespace {

using core::ErrorCode;
using core::failure;
using core::Result;

/// An entry before its meaning is checked, and where it stands.
struct ListEntry {
    QString where;
    QJsonObject fields;
    QHash<QString, QString> cells{}; ///< of a table, variables only
};

/// A list of a million studies has some hundred bytes for each.
constexpr qint64 largestList = 256 << 20;

Result<QByteArray> bytesOf(const QString& path)
{
    if (const Result<void> isFile = core::checkIsFile(path); !isFile)
        return tl::unexpected(isFile.error());
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    if (file.size() > largestList)
        return failure(
            ErrorCode::FileUnreadable, path, QStringLiteral("it is too long for a list"));
    return file.readAll();
}

/// A cell that reads as a number is one, so that it can stand for a number of the recipe. JSON has
/// none that are infinite or undefined: "nan" is a word. So is what names something: whole numbers
/// with a zero in front, or longer than a number keeps.
QJsonValue valueOf(const QString& cell)
{
    static const QRegularExpression name(QStringLiteral("^[-+]?(0\\d|\\d{16,}$)"));
    if (name.match(cell).hasMatch())
        return cell;
    bool isNumber = false;
    const double number = cell.toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? QJsonValue(number) : QJsonValue(cell);
}

bool isColumnOfOurs(const QString& name)
{
    static constexpr std::array columns{
        "study", "name", "session", "series", "repair", "spacing", "folder"};
    for (const char* column : columns) {
        if (name == QLatin1String(column))
            return true;
    }
    return false;
}

Result<std::vector<ListEntry>> entriesOfTable(const QString& path, QChar between)
{
    const Result<QByteArray> bytes = bytesOf(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    QString text = QString::fromUtf8(*bytes);
    if (text.startsWith(QChar::ByteOrderMark))
        text.remove(0, 1);
    const Result<std::vector<QStringList>> rows = readTable(text, between);
    if (!rows)
        return failure(ErrorCode::FileUnreadable, path, rows.error().arguments.value(1));
    std::vector<ListEntry> entries;
    QStringList columns;
    int line = 0;
    for (const QStringList& row : *rows) {
        ++line;
        if (row.size() == 1 && row.first().trimmed().isEmpty())
            continue;
        const QString where = QStringLiteral("line %1").arg(line);
        if (columns.isEmpty()) {
            for (const QString& cell : row)
                columns += cell.trimmed();
            if (QSet<QString>(columns.begin(), columns.end()).size() != columns.size())
                return failure(ErrorCode::FileUnreadable, path,
                    where + QStringLiteral(": two columns have the same name"));
            if (!columns.contains(QStringLiteral("study")))
                return failure(ErrorCode::FileUnreadable, path,
                    where + QStringLiteral(": no column is named 'study'"));
            continue;
        }
        if (row.size() != columns.size())
            return failure(ErrorCode::FileUnreadable, path,
                QStringLiteral("%1: %2 cells instead of %3")
                    .arg(where)
                    .arg(row.size())
                    .arg(columns.size()));
        ListEntry entry{where, {}};
        for (qsizetype i = 0; i < row.size(); ++i) {
            const QString cell = row[i].trimmed();
            const bool isOurs = isColumnOfOurs(columns[i]);
            entry.fields[columns[i]] = isOurs ? QJsonValue(cell) : valueOf(cell);
            if (!isOurs)
                entry.cells[columns[i]] = cell;
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

Result<std::vector<ListEntry>> entriesOfJson(const QString& path)
{
    const Result<QByteArray> bytes = bytesOf(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(*bytes, &problem);
    if (problem.error != QJsonParseError::NoError)
        return failure(ErrorCode::FileUnreadable, path,
            QStringLiteral("line %1: %2")
                .arg(bytes->left(problem.offset).count('\n') + 1)
                .arg(problem.errorString()));
    if (!document.isArray())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("it must be a list"));
    std::vector<ListEntry> entries;
    const QJsonArray list = document.array();
    for (const QJsonValue& value : list) {
        ListEntry entry{QStringLiteral("entry %1").arg(entries.size() + 1), value.toObject()};
        if (value.isString())
            entry.fields[QStringLiteral("study")] = value;
        else if (!value.isObject())
            return failure(ErrorCode::FileUnreadable, path,
                entry.where + QStringLiteral(": it must be a path or an object"));
        for (auto field = entry.fields.constBegin(); field != entry.fields.constEnd(); ++field) {
            const bool fits = isColumnOfOurs(field.key())
                ? field->isString()
                : field->isString() || field->isDouble() || field->isBool();
            if (!fits)
                return failure(ErrorCode::FileUnreadable, path,
                    QStringLiteral("%1: '%2' must be a text%3")
                        .arg(entry.where, field.key(),
                            isColumnOfOurs(field.key())
                                ? QString()
                                : QStringLiteral(", a number, true or false")));
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// Without the ending that tells the format: scan.nii.gz is "scan", but a folder 1.2.3 keeps all.
QString nameOf(const QString& study)
{
    const QFileInfo info(study);
    QString name = info.fileName();
    if (info.isDir())
        return name;
    if (name.endsWith(QLatin1String(".gz")))
        name.chop(3);
    const qsizetype dot = name.lastIndexOf(QLatin1Char('.'));
    return dot > 0 ? name.left(dot) : name;
}

/// The same place has the same name, also one that does not exist yet.
QString resolved(const QString& path)
{
    QFileInfo info(QDir::cleanPath(QDir().absoluteFilePath(path)));
    QStringList missing;
    while (!info.exists() && !info.isRoot()) {
        missing.prepend(info.fileName());
        info.setFile(info.path());
    }
    return QDir::cleanPath(QDir(info.canonicalFilePath()).filePath(missing.join(QLatin1Char('/'))));
}

/// Whether a folder is, or has in it, that with the results of the batch, or is one of them.
bool isOfResults(const QString& folder, const QString& results)
{
    const QString place = resolved(folder);
    const QString into = resolved(results);
    if (into == place || into.startsWith(place + QLatin1Char('/')))
        return true;
    const QDir inside(folder);
    return inside.exists(QStringLiteral("lock")) && inside.exists(QStringLiteral("record.json"));
}

/// Whether a file has no images of its own, by its name: it tells of a study, or is the part of one
/// that its header names.
bool isCompanion(const QString& file)
{
    const QString name =
        file.endsWith(QLatin1String(".gz"), Qt::CaseInsensitive) ? file.chopped(3) : file;
    static constexpr std::array endings{
        ".json", ".bval", ".bvec", ".raw", ".zraw", ".txt", ".csv", ".tsv", ".md"};
    return std::any_of(endings.begin(), endings.end(), [&name](const char* ending) {
        return name.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
    });
}

/// A file that says that it is DICOM, whatever its name (PS3.10 7.1).
bool saysDicom(const QString& path)
{
    constexpr qint64 length = 132;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    const QByteArray beginning = file.read(length);
    return beginning.size() == length && beginning.endsWith("DICM");
}

/// Documents of other programs are archives by their content too: the name has to say it as well.
bool isArchiveByName(const QString& path)
{
    static constexpr std::array endings{".zip", ".7z", ".tar", ".tar.gz", ".tgz", ".tar.bz2",
        ".tbz2", ".tar.xz", ".txz", ".tar.zst"};
    return std::any_of(endings.begin(), endings.end(), [&path](const char* ending) {
        return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
    }) && core::isArchive(path);
}

/// Each file and folder, but for results and for what lies beside studies. Of files that differ in
/// their endings alone (scan.nii.gz, scan.json) those count that are volumes, archives or DICOM.
Result<std::vector<ListEntry>> entriesOfFolder(
    const QString& path, const QString& results, QStringList& leftOut)
{
    const QDir folder(path);
    const auto isVolume = [&folder](const QString& name) {
        const QString file = folder.filePath(name);
        return QFileInfo(file).isFile() && (core::fileFormatOf(file) || isArchiveByName(file));
    };
    const QStringList names =
        folder.entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    QSet<QString> volumes;
    QSet<QString> ofVolumes;
    for (const QString& name : names) {
        if (!isVolume(name))
            continue;
        volumes.insert(name);
        ofVolumes.insert(nameOf(folder.filePath(name)));
    }
    std::vector<ListEntry> entries;
    for (const QString& name : names) {
        const QString file = folder.filePath(name);
        if (QFileInfo(file).isDir()) {
            if (!results.isEmpty() && isOfResults(file, results))
                continue;
        } else if (!volumes.contains(name)) {
            const bool mayBelong = isCompanion(name) || ofVolumes.contains(nameOf(file));
            if (mayBelong && !saysDicom(file)) {
                leftOut += name;
                continue;
            }
        }
        entries.push_back({name, {{QStringLiteral("study"), name}}});
    }
    return entries;
}

/// Why something cannot be a file's name among the results; empty: it can.
QString whyNoName(const QString& name)
{
    if (name.isEmpty() || name.size() > 100)
        return QStringLiteral("must have 1 to 100 characters");
    if (name.startsWith(QLatin1Char('.')) || name.startsWith(QLatin1Char('-')))
        return QStringLiteral("must not begin with a dot or a hyphen");
    for (const QChar each : name) {
        if (each == QLatin1Char('/') || each == QLatin1Char('\\') || !each.isPrint())
            return QStringLiteral("must not have slashes or characters that cannot be seen");
    }
    return {};
}

} // namespace

Result<std::vector<QStringList>> readTable(const QString& text, QChar between)
{
    std::vector<QStringList> rows;
    QStringList row;
    QString cell;
    bool quoted = false;
    const auto endCell = [&] {
        row += cell;
        cell.clear();
    };
    const auto endRow = [&] {
        endCell();
        rows.push_back(std::exchange(row, {}));
    };
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar each = text[i];
        const bool doubled =
            quoted && each == QLatin1Char('"') && text.mid(i + 1, 1) == QLatin1String("\"");
        if (doubled)
            cell += text[++i];
        else if (each == QLatin1Char('"') && (quoted || cell.isEmpty()))
            quoted = !quoted;
        else if (quoted)
            cell += each;
        else if (each == between)
            endCell();
        else if (each == QLatin1Char('\n'))
            endRow();
        else if (each != QLatin1Char('\r'))
            cell += each;
    }
    if (quoted)
        return failure(ErrorCode::InvalidField, QStringLiteral("table"),
            QStringLiteral("line %1: a quote is not closed").arg(rows.size() + 1));
    if (!cell.isEmpty() || !row.isEmpty())
        endRow();
    return rows;
}

Result<std::vector<BatchStudy>> readStudyList(
    const QString& path, const QString& results, QStringList* leftOut)
{
    const QFileInfo info(path);
    if (!info.exists())
        return failure(ErrorCode::FileNotFound, path);
    const QString ending = info.suffix().toLower();
    QStringList companions;
    const Result<std::vector<ListEntry>> entries = info.isDir()
        ? entriesOfFolder(path, results, companions)
        : ending == QLatin1String("json") ? entriesOfJson(path)
        : ending == QLatin1String("tsv")  ? entriesOfTable(path, QLatin1Char('\t'))
        : ending == QLatin1String("csv")
        ? entriesOfTable(path, QLatin1Char(','))
        : failure(ErrorCode::FileUnreadable, path,
            QStringLiteral("a list of studies is a .csv, .tsv or .json file, or a folder"));
    if (leftOut)
        *leftOut = companions;
    if (!entries)
        return tl::unexpected(entries.error());
    if (entries->empty())
        return info.isDir()
            ? failure(ErrorCode::FolderEmpty, path)
            : failure(ErrorCode::FileUnreadable, path, QStringLiteral("it lists no study"));
    const QDir beside(info.isDir() ? path : info.absolutePath());
    const QString apart = info.isDir()
        ? QStringLiteral("; a list of them with a column 'name' tells them apart")
        : ending == QLatin1String("json") ? QStringLiteral("; a 'name' tells them apart")
                                          : QStringLiteral("; a column 'name' tells them apart");
    std::vector<BatchStudy> studies;
    QHash<QString, QString> places;
    for (const ListEntry& entry : *entries) {
        const auto wrong = [&](const QString& why) {
            return failure(
                ErrorCode::FileUnreadable, path, entry.where + QStringLiteral(": ") + why);
        };
        QJsonObject fields = entry.fields;
        const auto take = [&fields](const char* name) {
            return fields.take(QLatin1String(name)).toString();
        };
        const QString study = take("study");
        if (study.isEmpty() || study.contains(QChar::Null))
            return wrong(QStringLiteral("it names no study"));
        BatchStudy found{.path = QDir::cleanPath(beside.absoluteFilePath(study)),
            .name = take("name"),
            .session = take("session"),
            .series = take("series"),
            .repair = take("repair"),
            .spacing = take("spacing")};
        const bool isNamed = !found.name.isEmpty();
        if (!isNamed)
            found.name = nameOf(found.path);
        if (const QString why = whyNoName(found.name); !why.isEmpty())
            return wrong(QStringLiteral("the name '%1' %2").arg(found.name, why));
        if (found.name == QLatin1String("results.csv"))
            return wrong(
                QStringLiteral("the name '%1' is that of the table of results").arg(found.name));
        if (fields.contains(QStringLiteral("folder")))
            return wrong(QStringLiteral("'folder' is a variable that Burin itself sets"));
        if (found.session.isEmpty())
            found.session = QStringLiteral("session.burin");
        if (const QString why = whyNoName(found.session); !why.isEmpty())
            return wrong(QStringLiteral("the session's name '%1' %2").arg(found.session, why));
        if (!found.session.endsWith(QLatin1String(".burin")))
            return wrong(
                QStringLiteral("the session's name '%1' must end in .burin").arg(found.session));
        if (const auto earlier = places.constFind(found.name); earlier != places.constEnd())
            return wrong(QStringLiteral("%1 has the name '%2' too%3")
                             .arg(*earlier, found.name, isNamed ? QString() : apart));
        places.insert(found.name, entry.where);
        found.variables = fields;
        found.cells = entry.cells;
        studies.push_back(std::move(found));
    }
    return studies;
}

} // namespace app
