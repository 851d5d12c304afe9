// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionPreview.h"

#include "core/sessionfile/database/SessionDatabase.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/RowText.h"

#include <QFileInfo>
#include <QSqlQuery>

#include <algorithm>

namespace core {

QDateTime sessionChangedAt(const QString& path)
{
    const QFileInfo file(path);
    const QFileInfo beside(path + QStringLiteral("-wal"));
    const QDateTime time = file.lastModified();
    return beside.exists() ? std::max(time, beside.lastModified()) : time;
}

Result<SessionPreview> previewSession(const QString& path)
{
    SessionPreview preview;
    preview.file = path;
    preview.lastChange = sessionChangedAt(path);
    if (!preview.lastChange.isValid())
        return failure(ErrorCode::FileNotFound, path);
    if (isSessionInUse(path)) {
        preview.condition = SessionPreview::Condition::InUse;
        return preview;
    }
    if (isSessionUnfinished(path))
        preview.condition = SessionPreview::Condition::Unfinished;
    Result<std::unique_ptr<SessionDatabase>> database = SessionDatabase::open(path, true);
    if (!database)
        return tl::unexpected(database.error());
    std::optional<SessionSource> source;
    const bool read = (*database)->query(QStringLiteral("SELECT json FROM source"), {},
                          [&source](const QSqlQuery& answer) {
                              source = SessionSource::fromJson(parsed(answer.value(0).toString()));
                              return true;
                          })
        // Ids run without gaps; counting would read every row.
        && (*database)->query(
            QStringLiteral("SELECT MAX(id) FROM row"), {}, [&preview](const QSqlQuery& answer) {
                preview.steps = answer.value(0).toLongLong();
                return true;
            });
    if (!read || !source)
        return failure(ErrorCode::SessionDamaged, path,
            !read ? Clause((*database)->reason())
                : !(*database)->loss().leftOpen.isEmpty()
                ? (*database)->loss().leftOpen
                : Clause::saying("it does not say what it was made on"));
    preview.source = *std::move(source);
    // A picture that cannot be read is one that is not there.
    (*database)->query(QStringLiteral("SELECT png FROM keyframe ORDER BY at DESC LIMIT 1"), {},
        [&preview](const QSqlQuery& answer) {
            preview.thumbnail = answer.value(0).toByteArray();
            return true;
        });
    return preview;
}

} // namespace core
