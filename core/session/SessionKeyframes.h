// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QByteArray>

#include <functional>
#include <vector>

namespace core {

class SessionState;

/// Small pictures of what was seen at rows of the history: at most one per row, kept only in the
/// session file. No call blocks. Part of EditSession.
class SessionKeyframes {
public:
    explicit SessionKeyframes(SessionState& state);

    /// The rows that have one, ascending.
    [[nodiscard]] std::vector<RowId> rows() const;
    /// Adds a picture, replacing the one that the row may have.
    void add(RowId row, const QByteArray& png);
    /// Reads the PNG of a row's picture; empty if it cannot be read. @p take is called once, on
    /// another thread (on this one if there is no file), before the session is destroyed.
    void fetch(RowId row, std::function<void(const QByteArray& png)> take) const;

private:
    SessionState& m_state;
};

} // namespace core
