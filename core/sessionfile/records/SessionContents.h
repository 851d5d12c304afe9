// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/base/words/Clause.h"
#include "core/history/History.h"
#include "core/sessionfile/records/Keyframe.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QJsonObject>

#include <optional>
#include <utility>
#include <vector>

namespace core {

/// What cannot be read of a session file; ui::damageText() words it. The chain runs by row number,
/// so nothing after the first unreadable row can be trusted, whatever its branch.
struct SessionDamage {
    RowId row = 0; ///< the first row that is lost; 0: no row is, but the position
    QString name; ///< its name as the file has it; may be empty
    std::int64_t after = 0; ///< rows after it that are lost with it; −1: unknown
    Clause reason;

    /// SessionDamaged with five arguments: the file, the reason, row, name and after.
    [[nodiscard]] Error error(const QString& path) const;
    /// The reverse; none if the error has no rows.
    [[nodiscard]] static std::optional<SessionDamage> of(const Error& error);
};

/// How a session file is opened.
enum class SessionAccess {
    ReadWrite,
    ReadOnly, ///< changes neither the file nor its folder
    SoundPart, ///< as ReadOnly, and damage is no error but is reported in SessionContents::damage
    PrivateCopy, ///< writes go to a temporary copy that is deleted at the end
};

/// Everything of a session file except the differences, which are read one by one.
struct SessionContents {
    SessionSource source;
    std::vector<HistoryRow> rows; ///< rows without second half have an empty stateHash
    std::vector<std::pair<RowId, RowId>> visited; ///< parent, child
    RowId position = 0;
    bool positionLost = false; ///< the position was at a lost row, or is unknown
    std::vector<int> hiddenSegments;
    std::vector<Keyframe> keyframes; ///< by row; without their pictures
    QString chainEnd; ///< hex; it covers the source and every row
    bool holdsImages = false; ///< of the study (SessionImages.h)
    QJsonObject display; ///< written by the window; empty: none
    std::optional<SessionDamage> damage; ///< rows and position are then those before it
    /// Rows without a sound difference whose edit and hash are sound, so they can be carried out
    /// again. Only checkSession() finds them.
    std::vector<SessionDamage> redo;
    Clause cutOff; ///< how much of the file is there, if not all of it
    Clause leftOpen; ///< why the last steps may be missing although no row is damaged
    /// nothing is missing: which files of another session lie beside this one, and what to do
    Clause leftBeside;

    /// Whether work can continue in the file as it is.
    [[nodiscard]] bool isWhole() const { return !damage && redo.empty() && cutOff.isEmpty(); }

    /// Keeps what precedes the damage. If the position is lost, it becomes the last row that is
    /// left.
    void cut(const SessionDamage& at);
};

} // namespace core
