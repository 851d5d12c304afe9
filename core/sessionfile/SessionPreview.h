// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <cstdint>

namespace core {

/// What can be told of a session file at a glance, to offer it.
struct SessionPreview {
    enum class Condition {
        Closed,
        Unfinished, ///< its program ended without closing it
        InUse, ///< open in another window: nothing below is read
    };
    QString file;
    QDateTime lastChange;
    Condition condition = Condition::Closed;
    SessionSource source;
    std::int64_t steps = 0; ///< rows of its history
    QByteArray thumbnail; ///< PNG: its newest keyframe; empty if it has none
};

/// Reads no row and checks no chain; touches neither the file nor its folder. Any thread.
/// Cost: a few pages of a closed file; a copy of one that is Unfinished.
/// Errors: those of SessionFile::open() but SessionDamaged for rows.
[[nodiscard]] Result<SessionPreview> previewSession(const QString& path);

} // namespace core
