// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyAttempt.h"

#include "app/batch/RecipeTemplate.h"
#include "core/base/files/PrivateFolder.h"
#include "core/base/files/StagedFile.h"
#include "core/base/files/StagedFolder.h"
#include "core/base/files/SystemFile.h"
#include "core/export/common/MaskSelection.h"
#include "core/export/common/StatisticsText.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/database/SessionUse.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QRegularExpression>

#include <cerrno>
#include <utility>

namespace app {

namespace {

using core::ErrorCode;
using core::failure;
using core::Result;

const auto fileField = QStringLiteral("file");
const auto hashField = QStringLiteral("sha256");

bool isLinkOrThere(const QString& path)
{
    const QFileInfo info(path);
    return info.isSymLink() || info.exists();
}

/// Whether this can only be the hidden folder of an attempt.
bool isHiddenFolder(const QString& path)
{
    static const QRegularExpression pattern(QStringLiteral("^\\.burin-[0-9a-f]{12}$"));
    const QFileInfo info(path);
    return pattern.match(info.fileName()).hasMatch() && info.isDir() && !info.isSymLink();
}

/// The file, or all files in the folder, by name.
QStringList filesAt(const QString& path)
{
    if (!QFileInfo(path).isDir())
        return {path};
    QStringList files;
    QDirIterator walk(path, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext())
        files += walk.next();
    files.sort();
    return files;
}

} // namespace

StudyAttempt::StudyAttempt(
    const QString& folder, QString session, const QByteArray& recipe, const QJsonObject& earlier)
    : m_places{QFileInfo(folder).canonicalFilePath()}
    , m_session(std::move(session))
    , m_name(QFileInfo(core::temporaryNameBeside(QDir(folder).filePath(QStringLiteral("attempt"))))
                 .fileName())
{
    const QJsonArray left = earlier.value(QStringLiteral("attempt")).toArray();
    for (const QJsonValue& each : left)
        m_left += each.toString();
    for (const char* list : {"made", "exports"}) {
        const QJsonArray files = earlier.value(QLatin1String(list)).toArray();
        for (const QJsonValue& each : files)
            m_made.insert(each[fileField].toString(), each[hashField].toString());
    }
    m_made.insert(earlier.value(QStringLiteral("session")).toString(),
        earlier.value(QStringLiteral("sessionSha256")).toString());

    m_targets += QDir(m_places.front()).filePath(m_session);
    QJsonObject content = QJsonDocument::fromJson(recipe).object();
    const QJsonArray asked = content.value(QStringLiteral("export")).toArray();
    QJsonArray exports;
    for (const QJsonValue& each : asked) {
        QJsonObject target = each.toObject();
        const QString file = target.value(fileField).toString();
        const QFileInfo info(QDir::cleanPath(QDir(folder).absoluteFilePath(file)));
        const QString place = file.isEmpty() || file.contains(QChar::Null)
            ? QString()
            : QFileInfo(info.path()).canonicalFilePath();
        // What names no folder that is there stays as it is: `burin run` says what is wrong.
        if (place.isEmpty()) {
            exports.append(each);
            continue;
        }
        if (!m_places.contains(place))
            m_places += place;
        m_targets += QDir(place).filePath(info.fileName());
        if (RecipeTemplate::bringsSeg(target))
            m_targets += core::segBeside(m_targets.back());
        target[fileField] = QDir(staged(place)).filePath(info.fileName());
        exports.append(target);
    }
    if (!exports.isEmpty())
        content[QStringLiteral("export")] = exports;
    m_recipe = QJsonDocument(content).toJson();
}

StudyAttempt::~StudyAttempt()
{
    discard();
}

QString StudyAttempt::hidden(const QString& place) const
{
    return QDir(place).filePath(m_name);
}

QString StudyAttempt::staged(const QString& place) const
{
    return hidden(place) + QStringLiteral("/new");
}

/// What was finished there.
QStringList StudyAttempt::entries(const QString& place) const
{
    QStringList names =
        QDir(staged(place)).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    const bool isOpen = place == m_places.front() && isSessionLeftOpen();
    names.removeIf([this, isOpen](const QString& name) {
        return name.startsWith(QLatin1String(".burin-")) || (isOpen && name == m_session)
            || name == m_session + QLatin1String("-wal")
            || name == m_session + QLatin1String("-shm")
            || name == m_session + QLatin1String("-journal");
    });
    return names;
}

bool StudyAttempt::isSessionLeftOpen() const
{
    return QFileInfo::exists(sessionPath())
        && !(core::strayPartOf(sessionPath()).isEmpty()
            && core::sessionLoss(sessionPath()).leftOpen.isEmpty());
}

/// As records name files: relative within the study's folder, else absolute.
QString StudyAttempt::nameOf(const QString& file) const
{
    const QString beside = QDir(m_places.front()).relativeFilePath(file);
    return beside.startsWith(QLatin1String("../")) ? file : beside;
}

Result<void> StudyAttempt::removeLeft() const
{
    for (const QString& folder : m_left) {
        if (isHiddenFolder(folder) && !QDir(folder).removeRecursively())
            return failure(ErrorCode::FileUnwritable, folder,
                QStringLiteral("an earlier attempt left it, and it cannot be removed"));
    }
    return {};
}

bool StudyAttempt::isOurs(const QString& target) const
{
    const auto isMade = [this](const QFileInfo& file) {
        if (file.isSymLink() || !file.isFile() || !m_made.contains(nameOf(file.filePath())))
            return false;
        const Result<QString> hash = core::sha256OfFile(file.filePath());
        return hash && m_made.contains(nameOf(file.filePath()), *hash);
    };
    const QFileInfo info(target);
    if (info.isSymLink() || !info.isDir())
        return isMade(info);
    QDirIterator walk(target, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
        QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QFileInfo each(walk.next());
        if ((each.isSymLink() || !each.isDir()) && !isMade(each))
            return false;
    }
    return true;
}

Result<void> StudyAttempt::checkTarget(const QString& target) const
{
    // A session has these beside it while it is open, and keeps them if it was cut off.
    bool isOpen = false;
    if (target == m_targets.front()) {
        for (const char* part : {"-wal", "-journal"})
            isOpen |= QFileInfo(target + QLatin1String(part)).size() > 0;
    }
    if (!isOpen && (!isLinkOrThere(target) || isOurs(target)))
        return {};
    return failure(ErrorCode::FileUnwritable, target,
        isOpen ? QStringLiteral("it is open, or was left open")
               : QStringLiteral("what has that name was not made by this batch, or was changed "
                                "since; move it away"));
}

Result<void> StudyAttempt::check() const
{
    for (const QString& target : m_targets) {
        if (const Result<void> fits = checkTarget(target); !fits)
            return fits;
    }
    return {};
}

void StudyAttempt::noteIn(QJsonObject& record) const
{
    QJsonArray folders;
    for (const QString& place : m_places)
        folders.append(hidden(place));
    record[QStringLiteral("attempt")] = folders;
    QJsonArray made;
    for (auto file = m_made.constBegin(); file != m_made.constEnd(); ++file) {
        if (!file.key().isEmpty() && !file.value().isEmpty())
            made.append(QJsonObject{{fileField, file.key()}, {hashField, file.value()}});
    }
    record.remove(QStringLiteral("made"));
    if (!made.isEmpty())
        record[QStringLiteral("made")] = made;
}

Result<void> StudyAttempt::begin()
{
    discard();
    for (const QString& place : std::as_const(m_places)) {
        if (!QDir().mkpath(staged(place)))
            return failure(
                ErrorCode::FileUnwritable, place, QStringLiteral("no folder can be made in it"));
    }
    QFile file(recipePath());
    // It has the values of the list, which may tell who the patient is.
    const QString named = told(file.fileName());
    if (!core::makePrivateFile(file.fileName()))
        return failure(ErrorCode::FileUnwritable, named, core::systemReason(errno));
    if (!file.open(QIODevice::WriteOnly) || file.write(m_recipe) != m_recipe.size()
        || !file.flush())
        return failure(ErrorCode::FileUnwritable, named, file.errorString());
    return {};
}

QString StudyAttempt::recipePath() const
{
    return QDir(hidden(m_places.front())).filePath(QStringLiteral("recipe.json"));
}

QString StudyAttempt::sessionPath() const
{
    return QDir(staged(m_places.front())).filePath(m_session);
}

QString StudyAttempt::told(QString text) const
{
    const QString folder = QLatin1Char('/') + m_name + QLatin1Char('/');
    text.replace(folder + QStringLiteral("new/"), QStringLiteral("/"));
    return text.replace(folder, QStringLiteral("/"));
}

bool StudyAttempt::closeSession() const
{
    if (isSessionLeftOpen())
        static_cast<void>(core::SessionFile::open(sessionPath(), core::SessionAccess::ReadWrite));
    return !isSessionLeftOpen();
}

Result<void> StudyAttempt::survey()
{
    static_cast<void>(closeSession());
    for (const QString& place : std::as_const(m_places)) {
        const QStringList names = entries(place);
        for (const QString& name : names) {
            const QStringList files = filesAt(QDir(staged(place)).filePath(name));
            for (const QString& file : files) {
                const Result<QString> hash = core::sha256OfFile(file);
                if (!hash)
                    return tl::unexpected(hash.error());
                const QString later = nameOf(told(file));
                m_made.insert(later, *hash);
                if (later == m_session)
                    m_sessionSha256 = *hash;
                else
                    m_exports.append(QJsonObject{{fileField, later}, {hashField, *hash}});
            }
        }
    }
    return {};
}

Result<void> StudyAttempt::place() const
{
    for (const QString& place : m_places) {
        const QStringList names = entries(place);
        for (const QString& name : names) {
            const Result<void> placed = placeOne(QDir(staged(place)).filePath(name), place, name);
            if (!placed)
                return placed;
        }
    }
    return {};
}

Result<void> StudyAttempt::placeOne(
    const QString& from, const QString& place, const QString& name) const
{
    const QString target = QDir(place).filePath(name);
    if (const Result<void> fits = checkTarget(target); !fits)
        return fits;
    if (!QFileInfo(from).isDir())
        return core::StagedFile::adopt(from, target).commit();
    // What an earlier attempt made has its name until this one has it.
    return core::StagedFolder::adopt(from, target, isLinkOrThere(target)).commit();
}

void StudyAttempt::concludeIn(QJsonObject& record) const
{
    record[QStringLiteral("exports")] = m_exports;
    QStringList told;
    if (!m_sessionSha256.isEmpty()) {
        record[QStringLiteral("sessionSha256")] = m_sessionSha256;
        told += m_session;
    }
    for (const QJsonValue& each : m_exports)
        told += each[fileField].toString();
    QJsonArray others;
    const QJsonArray made = record.value(QStringLiteral("made")).toArray();
    for (const QJsonValue& each : made) {
        const QString file = each[fileField].toString();
        if (!told.contains(file) && isLinkOrThere(QDir(m_places.front()).absoluteFilePath(file)))
            others.append(each);
    }
    record.remove(QStringLiteral("made"));
    if (!others.isEmpty())
        record[QStringLiteral("made")] = others;
}

void StudyAttempt::discard() const
{
    for (const QString& place : m_places) {
        if (isHiddenFolder(hidden(place)))
            QDir(hidden(place)).removeRecursively();
    }
}

} // namespace app
