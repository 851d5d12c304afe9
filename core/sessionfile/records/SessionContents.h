// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/sessionfile/records/Keyframe.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QJsonObject>

#include <optional>
#include <utility>
#include <vector>

namespace core {

/// What cannot be read of a session file. The chain runs by row id, so behind the first unreadable
/// row nothing can be trusted, whatever branch it lies on.
struct SessionDamage {
    RowId row = 0; ///< the first row that is lost; 0: no row, but where the session stood
    QString name; ///< of that row, as it stands there; may be empty
    std::int64_t after = 0; ///< rows behind it that are lost with it; -1: nobody can tell
    QString reason;

    /// "row 17 'Drill 5 mm' and the 5 after it cannot be read: …"
    [[nodiscard]] QString text() const;
};

/// How a session file is opened.
enum class SessionAccess {
    ReadWrite,
    ReadOnly, ///< neither the file nor its folder is touched
    SoundPart, ///< ReadOnly, and a damaged file is no error: SessionContents::damage
    PrivateCopy, ///< what is written goes into a copy that vanishes with it
};

/// Everything of a session file but the differences, which are read one by one.
struct SessionContents {
    SessionSource source;
    std::vector<HistoryRow> rows; ///< those without second half have an empty stateHash
    std::vector<std::pair<RowId, RowId>> visited; ///< parent, child
    RowId position = 0;
    bool positionLost = false; ///< it stood at a row that is lost, or nobody can tell where
    std::vector<int> hiddenSegments;
    std::vector<Keyframe> keyframes; ///< by row; without their pictures
    QString chainEnd; ///< hex; it covers the source and every row
    bool holdsImages = false; ///< of the study (SessionImages.h)
    QJsonObject display; ///< as the window put it together; empty: none kept
    std::optional<SessionDamage> damage; ///< then rows and position are those before it
    /// Rows that lack a sound difference while their edit and their hash are sound: they can be
    /// carried out again. Told by checkSession() only.
    std::vector<SessionDamage> redo;
    QString cutOff; ///< how much of the file is there, if not all of it
    QString leftOpen; ///< why its last steps may be missing though no row is damaged

    /// The file can be gone on with as it is.
    [[nodiscard]] bool isWhole() const { return !damage && redo.empty() && cutOff.isEmpty(); }

    /// Every problem as a sentence without a stop, the rows that are lost first; empty: none.
    [[nodiscard]] std::vector<QString> problems() const;

    /// Keeps what comes before the damage. A position behind it becomes the last row that is left.
    void cut(const SessionDamage& at);
};

} // namespace core
