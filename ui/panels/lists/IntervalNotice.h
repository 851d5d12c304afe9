// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QObject>

#include <cstddef>

namespace ui {

class Workspace;

/// Says once, in the status line, when a step ends that a segment follows its interval of values.
/// Undo and redo of such a step say nothing: the list of segments shows it.
class IntervalNotice : public QObject {
    Q_OBJECT

public:
    explicit IntervalNotice(Workspace& workspace, QObject* parent = nullptr);

private:
    void begin(); ///< with the history as it is
    void look(); ///< at what has come to it
    [[nodiscard]] QString sentenceOf(const core::HistoryRow& row) const;

    Workspace& m_workspace;
    std::size_t m_known = 0; ///< rows that were looked at
};

} // namespace ui
