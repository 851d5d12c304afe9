// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionPlan.h"

#include "app/steps/SessionFiles.h"
#include "core/base/files/SystemFile.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionContents.h"
#include "ui/texts/SessionTexts.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>

#include <cerrno>

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
    } while (core::isSessionNameTaken(path));
    return path;
}

bool holdsImages(const QString& file)
{
    const auto session = core::SessionFile::open(file, core::SessionFile::Access::ReadOnly);
    return session && (*session)->contents().holdsImages;
}

/// What is told, besides which file is damaged.
QString newsOf(const core::SessionContents& contents, const QString& target, bool imagesLost)
{
    const std::size_t left = contents.rows.size();
    const QString where =
        QStringLiteral("open in %1; the damaged file keeps its bytes%2")
            .arg(target,
                imagesLost ? QStringLiteral(", and the study's images, which are damaged too")
                           : QString());
    if (contents.damage && contents.damage->row > 0)
        return left == 1 ? QStringLiteral("%1. The row before it is %2")
                               .arg(ui::damageText(*contents.damage), where)
                         : QStringLiteral("%1. The %2 rows before it are %3")
                               .arg(ui::damageText(*contents.damage))
                               .arg(left)
                               .arg(where);
    if (contents.damage)
        return QStringLiteral("%1. All rows are %2").arg(ui::damageText(*contents.damage), where);
    if (contents.redo.empty())
        return QStringLiteral("%1. No row is lost; everything is %2").arg(contents.cutOff, where);
    const core::SessionDamage& first = contents.redo.front();
    const std::size_t others = contents.redo.size() - 1;
    return QStringLiteral("what row %1 '%2'%3 changed could not be read; it was carried out again "
                          "and came to the same. Nothing is lost; everything is %4")
        .arg(first.row)
        .arg(first.name, others == 0 ? QString() : QStringLiteral(" (and %1 more)").arg(others),
            where);
}

core::Error told(
    const QString& damaged, const core::SessionContents& contents, const QString& target)
{
    const bool imagesLost = contents.holdsImages && !holdsImages(target);
    return {core::ErrorCode::SessionDamaged,
        {damaged, newsOf(contents, QFileInfo(target).fileName(), imagesLost)}};
}

SessionPlan planAround(const QString& damaged, const core::SessionContents& contents,
    const QString& target, bool isNew)
{
    SessionPlan plan{.file = target,
        .whyReadOnly = {},
        .damage = told(damaged, contents, target),
        .isNew = isNew,
        .damaged = damaged,
        .redo = {}};
    for (const core::SessionDamage& row : contents.redo)
        plan.redo.emplace_back(row.row, contents.rows[std::size_t(row.row - 1)].stateHash);
    return plan;
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
        return planAround(file, contents, target, true);
    }
    if (core::isSessionInUse(file))
        return core::failure(
            core::ErrorCode::SessionDamaged, file, ui::problemTexts(contents).front());
    // The study finds its working session by name, so the damaged one gives that up.
    const QString aside = file + QStringLiteral(".damaged-")
        + QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    const QString target = file + QStringLiteral(".salvaged");
    core::removeSession(target);
    if (const auto salvaged = core::salvageSession(file, contents, target); !salvaged)
        return tl::unexpected(salvaged.error());
    core::Result<void> renamed = renameSession(file, aside);
    if (renamed) {
        renamed = renameSession(target, file);
        if (!renamed && !renameSession(aside, file))
            renamed.error().arguments.set(1,
                QStringLiteral("%1; the damaged session is in '%2' now")
                    .arg(renamed.error().arguments.value(1), QFileInfo(aside).fileName()));
    }
    if (!renamed) {
        core::removeSession(target);
        return tl::unexpected(renamed.error());
    }
    return planAround(aside, contents, file, false);
}

} // namespace

// Not by QFile::rename(), which copies where it must not.
core::Result<void> renameSession(const QString& from, const QString& to)
{
    const auto refused = [&from, &to](int error) {
        return core::failure(core::ErrorCode::FileUnwritable, from,
            QStringLiteral("it cannot be renamed to '%1': %2")
                .arg(QFileInfo(to).fileName(), core::systemReason(error)));
    };
    // What lies beside that name would come to belong to the session.
    if (core::isSessionNameTaken(to))
        return refused(EEXIST);
    QStringList renamed;
    for (const char* suffix : {"-wal", "-shm", "-journal", ""}) {
        const QLatin1String part(suffix);
        if (!QFileInfo::exists(from + part))
            continue;
        if (core::renameToFreeName(from + part, to + part)) {
            renamed += part;
            continue;
        }
        const int error = errno;
        for (const QString& each : renamed)
            static_cast<void>(core::renameToFreeName(to + each, from + each));
        return refused(error);
    }
    return {};
}

core::Result<SessionPlan> planFor(const QString& file, core::SessionContents contents, bool redo)
{
    if (!redo && !contents.redo.empty()) {
        const core::SessionDamage first = contents.redo.front();
        contents.cut(first);
    }
    if (contents.damage && contents.rows.empty())
        return tl::unexpected(contents.damage->error(file));
    if (!contents.isWhole())
        return aroundDamage(file, contents);
    return SessionPlan{.file = file,
        .whyReadOnly = whyReadOnly(file),
        .damage = {},
        .isNew = false,
        .damaged = {},
        .redo = {}};
}

core::Result<std::unique_ptr<core::EditSession>> openPlanned(core::EditEngine& engine,
    core::LoadedVolume loaded, const SessionPlan& plan, const std::function<void()>& wakeUp)
{
    if (!plan.whyReadOnly.isEmpty())
        return core::EditSession::view(
            engine, std::move(loaded), plan.file, plan.whyReadOnly, wakeUp);
    auto session = core::EditSession::open(engine, std::move(loaded), plan.file, wakeUp);
    for (const auto& [row, hash] : plan.redo) {
        if (session && (*session)->history().row(row).stateHash != hash)
            return core::failure(core::ErrorCode::SessionDamaged, plan.damaged);
    }
    return session;
}

core::Result<void> withdraw(const SessionPlan& plan, const QString& file)
{
    core::removeSession(plan.file);
    return plan.damaged == file ? core::Result<void>() : renameSession(plan.damaged, file);
}

} // namespace app
