// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/delta/BrickDelta.h"
#include "core/history/History.h"

#include <QByteArray>

#include <functional>
#include <list>
#include <memory>
#include <optional>

namespace core {

class SessionTables;

/// One write into a session file that is waiting for the disk.
struct SessionWrite {
    std::function<Result<void>(SessionTables&)> carryOut; ///< may be called again after a failure
    RowId row = 0; ///< the row whose second half this is; 0: another write
    std::shared_ptr<const BrickDelta> delta; ///< of that row
    QByteArray picture{}; ///< of that row
    bool isStep = false; ///< whether the user would lose a step without it
};

/// The writes into a session file, in order. What the disk does not accept waits here with all that
/// follow it. Part of SessionFile; belongs to its writer's thread.
class SessionWrites {
public:
    using List = std::list<SessionWrite>;

    /// Adds writes without throwing; @p writes is empty afterwards.
    void append(List& writes) noexcept { m_waiting.splice(m_waiting.end(), writes); }
    /// Carries out all writes up to the first that fails. @param path named in errors:
    /// FileUnwritable
    [[nodiscard]] std::optional<Error> carryOut(SessionTables& tables, const QString& path);
    /// Carries out all of them in a copy and keeps them here.
    [[nodiscard]] Result<void> carryOutIn(SessionTables& copy) const;
    void clear() { m_waiting.clear(); }

    [[nodiscard]] bool holdStep() const;
    /// The last picture of a row that waits; null if none does.
    [[nodiscard]] const QByteArray* pictureOf(RowId row) const;
    [[nodiscard]] const BrickDelta* deltaOf(RowId row) const;

private:
    List m_waiting;
};

} // namespace core
