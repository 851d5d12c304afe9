// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyResults.h"

#include "core/base/files/PrivateFolder.h"
#include "core/base/files/ReadableFile.h"
#include "core/base/files/StagedFile.h"
#include "core/base/files/SystemFile.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <cerrno>
#include <utility>

#include <sys/file.h>

namespace app {

using core::ErrorCode;
using core::failure;
using core::Result;

namespace {

enum class Readers { Everyone, OwnerAlone };

Result<void> writeFile(
    const QString& path, const QByteArray& content, bool replaceExisting, Readers readers)
{
    Result<core::StagedFile> staged = core::StagedFile::create(path, replaceExisting);
    if (!staged)
        return tl::unexpected(staged.error());
    if (readers == Readers::OwnerAlone && !core::makePrivateFile(staged->path()))
        return failure(ErrorCode::FileUnwritable, path, core::systemReason(errno));
    QFile file(staged->path());
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.flush())
        return failure(ErrorCode::FileUnwritable, path, file.errorString());
    file.close();
    return staged->commit();
}

} // namespace

Result<StudyResults::Turn> StudyResults::begin(const QString& folder)
{
    if (!QDir().mkpath(folder))
        return failure(
            ErrorCode::FileUnwritable, folder, QStringLiteral("the folder cannot be made"));
    const QString path = QDir(folder).filePath(QStringLiteral("lock"));
    if (!QFileInfo::exists(path)) {
        const QStringList there =
            QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
        bool isForeign = false;
        for (const QString& each : there)
            isForeign |=
                !each.startsWith(QLatin1String(".burin-")) && each != QLatin1String("lock");
        if (isForeign)
            return failure(ErrorCode::FileUnwritable, folder,
                QStringLiteral("it has files that no batch has made, such as %1")
                    .arg(there.last()));
        const Result<void> made = writeFile(path, "burin batch\n", false, Readers::Everyone);
        // Another may have been faster.
        if (!made && made.error().code != ErrorCode::FileExists)
            return tl::unexpected(made.error());
    }
    auto file = std::make_unique<QFile>(path);
    if (!file->open(QIODevice::ReadWrite | QIODevice::ExistingOnly))
        return failure(ErrorCode::FileUnwritable, path, file->errorString());
    if (::flock(file->handle(), LOCK_EX | LOCK_NB) != 0) {
        const int error = errno;
        if (error == EWOULDBLOCK)
            return Turn::Another;
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("it cannot be locked: %1").arg(core::systemReason(error)));
    }
    m_lock = std::move(file);
    return Turn::Mine;
}

void StudyResults::end()
{
    // Explicitly: a child of this process may still hold the same lock for a moment.
    if (m_lock)
        ::flock(m_lock->handle(), LOCK_UN);
    m_lock.reset();
}

Result<void> StudyResults::write(const QString& folder, const char* name, const QByteArray& content)
{
    // The table was asked for; the others tell where a study lies and what its recipe was given.
    const bool isTable = QLatin1String(name) == QLatin1String("results.csv");
    return writeFile(QDir(folder).filePath(QLatin1String(name)), content, true,
        isTable ? Readers::Everyone : Readers::OwnerAlone);
}

QJsonObject StudyResults::record(const QString& folder)
{
    QFile file(QDir(folder).filePath(QStringLiteral("record.json")));
    if (!core::checkIsFile(file.fileName()) || !file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.readAll()).object();
}

bool StudyResults::isDone(const QString& folder)
{
    const QJsonObject record = StudyResults::record(folder);
    if (record.value(QStringLiteral("state")).toString() != QLatin1String("done"))
        return false;
    const QDir here(folder);
    if (!QFileInfo::exists(here.filePath(record.value(QStringLiteral("session")).toString())))
        return false;
    const QJsonArray exports = record.value(QStringLiteral("exports")).toArray();
    for (const QJsonValue& each : exports) {
        const QString file = each.toObject().value(QStringLiteral("file")).toString();
        if (!QFileInfo::exists(here.absoluteFilePath(file)))
            return false;
    }
    return true;
}

} // namespace app
