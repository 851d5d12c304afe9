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

struct SessionWrite {
    std::function<Result<void>(SessionTables&)> carryOut; ///< may be done over
    RowId row = 0; ///< whose second half it is; 0: another write
    std::shared_ptr<const BrickDelta> delta; ///< of that row
    QByteArray picture{}; ///< of that row
    bool isStep = false; ///< what the user would miss
};

/// What is to be written into a session file, in order; what the disk does not take waits here with
/// all that follows it. Part of SessionFile; belongs to its writer's thread.
class SessionWrites {
public:
    using List = std::list<SessionWrite>;

    /// Throws nothing. @p writes is empty then
    void append(List& writes) noexcept { m_waiting.splice(m_waiting.end(), writes); }
    /// Up to the first that fails. @param path for errors: FileUnwritable
    [[nodiscard]] std::optional<Error> carryOut(SessionTables& tables, const QString& path);
    /// All of them in a copy; they stay.
    [[nodiscard]] Result<void> carryOutIn(SessionTables& copy) const;
    void clear() { m_waiting.clear(); }

    [[nodiscard]] bool holdStep() const;
    /// Of a row, the last that waits; null: none does.
    [[nodiscard]] const QByteArray* pictureOf(RowId row) const;
    [[nodiscard]] const BrickDelta* deltaOf(RowId row) const;

private:
    List m_waiting;
};

} // namespace core
