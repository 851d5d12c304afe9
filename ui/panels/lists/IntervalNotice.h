// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QObject>

#include <cstddef>

namespace ui {

class Workspace;

/// Tells the user in the status line when a step has ended that a segment follows its interval of
/// values. Undo and redo of such a step are not reported, because the list of segments shows it.
class IntervalNotice : public QObject {
    Q_OBJECT

public:
    explicit IntervalNotice(Workspace& workspace, QObject* parent = nullptr);

private:
    void begin(); ///< counts the rows of the history so far as reported
    void look(); ///< reports new rows
    [[nodiscard]] QString sentenceOf(const core::HistoryRow& row) const;

    Workspace& m_workspace;
    std::size_t m_known = 0; ///< number of the history's rows that were looked at
};

} // namespace ui
