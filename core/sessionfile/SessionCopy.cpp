// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionCopy.h"

#include "core/base/files/StagedFile.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/SessionWrites.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionTables.h"

#include <QFile>

#include <utility>

namespace core {

Result<void> copySessionInto(
    const QString& path, const SessionParts& parts, const SavedImages& images)
{
    const bool leavesOut = parts.tables && parts.tables->holdsImages() && !images.kept;
    const bool begun = images.staged || leavesOut || !parts.tables;
    if (begun && !images.staged) {
        SessionTables empty(path);
        if (const Result<void> made = empty.create(parts.source); !made)
            return made;
    }
    if (parts.tables) {
        const Result<void> copied =
            begun ? parts.tables->copyHistoryInto(path) : parts.tables->copyInto(path);
        if (!copied)
            return copied;
    }
    // Opened as any session is: rows and chain are there.
    SessionTables copy(path);
    if (const Result<SessionContents> read = copy.open(SessionAccess::ReadWrite); !read)
        return tl::unexpected(read.error());
    return parts.waiting.carryOutIn(copy);
}

Result<std::shared_ptr<StagedFile>> stageSessionCopy(const QString& target, bool replaceExisting,
    bool ownPlace, const SessionParts& parts, const SavedImages& images)
{
    if (!ownPlace) {
        if (const Result<void> free = checkOtherSessionAt(target, replaceExisting); !free)
            return tl::unexpected(free.error());
    }
    std::shared_ptr<StagedFile> staged = images.staged;
    if (!staged) {
        Result<StagedFile> made = StagedFile::create(target, replaceExisting, ownPlace);
        if (!made)
            return tl::unexpected(made.error());
        staged = std::make_shared<StagedFile>(*std::move(made));
        QFile::setPermissions(staged->path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    }
    const QString path = staged->path();
    if (const Result<void> whole = copySessionInto(path, parts, images); !whole) {
        removeSession(path);
        Error error = whole.error();
        error.arguments.set(0, target);
        return tl::unexpected(std::move(error));
    }
    return staged;
}

} // namespace core
