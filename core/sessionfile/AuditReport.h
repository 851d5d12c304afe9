// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QString>

#include <vector>

namespace core {

class SessionTables;

/// One row of a session as it appears in an audit.
struct AuditStep {
    enum class Standing {
        Done, ///< on the path to the current position
        TakenBack, ///< on that path, but a later step undid this one alone
        Undone, ///< redo would bring it back
        OtherBranch, ///< on another branch
    };
    HistoryRow row;
    Standing standing = Standing::Done;
    RowId takenBackBy = 0;
    RowId revisedBy = 0; ///< the last step in effect that changed or removed this stroke
};

/// What a session file says was done, and whether it can be trusted: everything is read again, and
/// every hash that can be checked without the study is checked.
struct AuditReport {
    QString file; ///< file name without folders
    SessionSource source;
    std::vector<AuditStep> steps; ///< by row
    std::vector<HistoryBranch> branches; ///< the current line first
    RowId position = 0;
    std::vector<Keyframe> keyframes; ///< by row, with their pictures
    QString chainEnd; ///< hex; covers the source and every row
    int sealed = 0; ///< rows whose second half exists and whose difference has its hash
    /// differences that do not match their hash, and what follows the last sound row
    std::vector<Error> damage;
    RowOrigin made; ///< of the report
};

/// Reads all of a session; the report names damage. Called on the thread of @p tables. Cost: the
/// file is read once. Errors: SessionDamaged if not even the source of the session can be read.
[[nodiscard]] Result<AuditReport> auditReport(SessionTables& tables, const QString& path);

} // namespace core
