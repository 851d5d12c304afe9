// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QString>

#include <vector>

namespace core {

class SessionTables;

/// One row of a session as an audit shows it.
struct AuditStep {
    enum class Standing {
        Done, ///< on the way to where the session stands
        TakenBack, ///< the same, but a later step undid it alone
        Undone, ///< redo would bring it back
        OtherBranch, ///< on an old future
    };
    HistoryRow row;
    Standing standing = Standing::Done;
    RowId takenBackBy = 0;
    RowId revisedBy = 0; ///< the last step that stands and changed or removed this stroke
};

/// What a session's file says was done, and whether it can be believed: everything read anew, and
/// every hash that can be checked without the study checked.
struct AuditReport {
    QString file; ///< its name, without folders
    SessionSource source;
    std::vector<AuditStep> steps; ///< by row
    std::vector<HistoryBranch> branches; ///< the current line first
    RowId position = 0;
    std::vector<Keyframe> keyframes; ///< by row, with their pictures
    QString chainEnd; ///< hex; covers the source and every row
    int sealed = 0; ///< rows whose second half is there and whose difference has its hash
    std::vector<Error> damage; ///< differences that do not, and what follows the last sound row
    RowOrigin made; ///< of the report
};

/// Reads all of a session; the report says so where it is damaged. Belongs to the thread of
/// @p tables. Cost: reads the file once. Errors: SessionDamaged where it does not even say what it
/// was made on.
[[nodiscard]] Result<AuditReport> auditReport(SessionTables& tables, const QString& path);

} // namespace core
