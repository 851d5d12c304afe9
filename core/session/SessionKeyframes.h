// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QByteArray>

#include <functional>
#include <vector>

namespace core {

class SessionState;

/// Small pictures of what was seen at rows of the history, one a row, kept in the session file and
/// nowhere else. Nothing here waits. Part of EditSession.
class SessionKeyframes {
public:
    explicit SessionKeyframes(SessionState& state);

    /// Rows that have one, ascending.
    [[nodiscard]] std::vector<RowId> rows() const;
    /// In place of the one that the row may have.
    void add(RowId row, const QByteArray& png);
    /// The PNG of a row's picture; empty: it cannot be read. @p take is called once, on another
    /// thread (on this one where there is no file), before the session is gone.
    void fetch(RowId row, std::function<void(const QByteArray& png)> take) const;

private:
    SessionState& m_state;
};

} // namespace core
