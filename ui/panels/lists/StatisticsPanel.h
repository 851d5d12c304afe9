// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"
#include "ui/measure/LiveStatistics.h"

#include <vector>

class QAction;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace ui {

class StatisticsModel;
class Workspace;

/// The statistics of all segments as a table: what an export writes, worked out beside the window
/// whenever a segment has changed. Only a panel that is seen works anything out. A click on a
/// column's header sorts, a right click chooses the columns; rows are copied as text.
class StatisticsPanel : public Panel {
    Q_OBJECT

public:
    explicit StatisticsPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }
    [[nodiscard]] const LiveStatistics& statistics() const { return m_statistics; }
    /// The selected rows, or all if none is, with a line of headings: what is shown, in the order
    /// in which it is shown, parted by tabs. Numbers are as long as in an exported table.
    [[nodiscard]] QString asText() const;

Q_SIGNALS:
    /// The user wants to write the statistics into a file.
    void exportRequested();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildTable();
    void addColumnChoice();
    void chooseColumns();
    void refresh();

    LiveStatistics m_statistics;
    StatisticsModel* m_model = nullptr;
    QSortFilterProxyModel* m_sorted = nullptr;
    QTableView* m_table = nullptr;
    QLabel* m_empty = nullptr;
    QPushButton* m_export = nullptr;
    std::vector<QAction*> m_columns; ///< whether each is shown; the first is column 1
};

} // namespace ui
