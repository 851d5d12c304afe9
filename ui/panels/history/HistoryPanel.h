// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "ui/frame/Panel.h"

#include <optional>
#include <utility>

class QListView;
class QMenu;
class QModelIndex;

namespace ui {

class HistoryModel;
class HistoryTimeline;
class StrokeRevision;
class Workspace;

/// The panel of the history: all steps, oldest first, with abandoned futures as branches that
/// unfold (by a click on the arrow, or Right and Left), and what was changed of the view between
/// them. A double click or Return goes to a step.
/// The menu of a row also undoes that step alone, and changes or removes a stroke out of order.
/// Below, the timeline moves along the current line.
class HistoryPanel : public Panel {
    Q_OBJECT

public:
    explicit HistoryPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool stretches() const override { return true; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void followPosition(int row);
    void fold(const QModelIndex& heading, bool folded);
    /// Left: folds, or goes to the heading. Right: unfolds, or goes to the first row.
    bool takeFoldKey(int key);
    void goTo(const QModelIndex& index);
    void undoOnly(const QModelIndex& index);
    void addStrokeActions(QMenu& menu, core::RowId row);
    void showMenu(const QPoint& position);

    Workspace& m_workspace;
    HistoryModel* m_model = nullptr;
    QListView* m_view = nullptr;
    HistoryTimeline* m_timeline = nullptr;
    StrokeRevision* m_revision = nullptr;
    /// The position to which the list was last scrolled: a row, and a change of the view there.
    std::optional<std::pair<core::RowId, int>> m_shownPosition;
};

} // namespace ui
