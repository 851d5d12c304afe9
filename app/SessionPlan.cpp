// SPDX-License-Identifier: Apache-2.0
#include "app/SessionPlan.h"

#include "app/SessionFiles.h"
#include "core/session/SessionContents.h"
#include "core/session/SessionSalvage.h"
#include "core/session/SessionUse.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>

namespace app {

namespace {

QString whyReadOnly(const QString& file)
{
    if (core::isSessionInUse(file))
        return QStringLiteral("open in another window");
    const QFileInfo info(file);
    const QFileInfo folder(info.absolutePath());
    if (info.isWritable() && folder.isWritable())
        return {};
    return QStorageInfo(folder.filePath()).isReadOnly() ? QStringLiteral("on a read-only disk")
        : folder.isWritable() ? QStringLiteral("the file is write-protected")
                              : QStringLiteral("its folder cannot be written");
}

/// "case (recovered).burin", "case (recovered 2).burin" …
QString freeNameIn(const QString& folder, const QString& name)
{
    QString path;
    int count = 1;
    do {
        const QString number = count == 1 ? QString() : QStringLiteral(" %1").arg(count);
        path = QDir(folder).filePath(QStringLiteral("%1 (recovered%2).burin").arg(name, number));
        ++count;
    } while (QFileInfo::exists(path));
    return path;
}

core::Error lost(
    const QString& damaged, const core::SessionContents& contents, const QString& target)
{
    const std::size_t left = contents.rows.size();
    const QString rows = left == 1 ? QStringLiteral("The row before it is")
                                   : QStringLiteral("The %1 rows before it are").arg(left);
    const bool allThere = contents.damage->row == 0;
    return {core::ErrorCode::SessionDamaged,
        {damaged,
            QStringLiteral("%1. %2 open in %3; the damaged file keeps its bytes")
                .arg(contents.damage->text(), allThere ? QStringLiteral("All rows are") : rows,
                    target)}};
}

core::Result<SessionPlan> aroundDamage(const QString& file, const core::SessionContents& contents)
{
    const QFileInfo info(file);
    if (!isWorkingSession(file)) {
        const bool beside = QFileInfo(info.absolutePath()).isWritable();
        const QString target =
            freeNameIn(beside ? info.absolutePath() : sessionFolder(), info.completeBaseName());
        if (const auto salvaged = core::salvageSession(file, contents, target); !salvaged)
            return tl::unexpected(salvaged.error());
        return SessionPlan{.file = target,
            .whyReadOnly = {},
            .damage = lost(file, contents, QFileInfo(target).fileName()),
            .isNew = true};
    }
    if (core::isSessionInUse(file))
        return core::failure(core::ErrorCode::SessionDamaged, file, contents.damage->text());
    // The study finds its working session by name, so the damaged one gives that up.
    const QString aside = file + QStringLiteral(".damaged-")
        + QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    const QString target = file + QStringLiteral(".salvaged");
    core::removeSession(target);
    if (const auto salvaged = core::salvageSession(file, contents, target); !salvaged)
        return tl::unexpected(salvaged.error());
    for (const char* suffix : {"-wal", "-journal", ""}) {
        const QString part = file + QLatin1String(suffix);
        if (QFileInfo::exists(part) && !QFile::rename(part, aside + QLatin1String(suffix)))
            return core::failure(core::ErrorCode::FileUnwritable, aside);
    }
    if (!QFile::rename(target, file))
        return core::failure(core::ErrorCode::FileUnwritable, file);
    return SessionPlan{.file = file,
        .whyReadOnly = {},
        .damage = lost(aside, contents, QFileInfo(file).fileName()),
        .isNew = false};
}

} // namespace

core::Result<SessionPlan> planFor(const QString& file, const core::SessionContents& contents)
{
    if (contents.damage)
        return aroundDamage(file, contents);
    return SessionPlan{
        .file = file, .whyReadOnly = whyReadOnly(file), .damage = {}, .isNew = false};
}

} // namespace app
