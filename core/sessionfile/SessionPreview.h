// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <cstdint>

namespace core {

/// A short description of a session file for the list of the start page.
struct SessionPreview {
    enum class Condition {
        Closed,
        Unfinished, ///< its program ended without closing it
        InUse, ///< open in another window; the members below are not read
    };
    QString file;
    QDateTime lastChange;
    Condition condition = Condition::Closed;
    SessionSource source;
    std::int64_t steps = 0; ///< rows of its history
    QByteArray thumbnail; ///< PNG: its newest keyframe; empty if it has none
};

/// When it was written last, with what SQLite keeps beside it; invalid: it is not there.
[[nodiscard]] QDateTime sessionChangedAt(const QString& path);

/// Reads it. No row is read and no chain checked; neither the file nor its folder is changed. Any
/// thread.
/// Cost: a few pages of a closed file; a copy of one that is Unfinished.
/// Errors: those of SessionFile::open(), except SessionDamaged for rows.
[[nodiscard]] Result<SessionPreview> previewSession(const QString& path);

} // namespace core
