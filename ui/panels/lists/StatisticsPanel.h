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

/// A table of the statistics of all segments: the numbers that an export writes, measured in the
/// background after each change. Nothing is measured while the panel is hidden. A click on a
/// column's header sorts; a right click on it chooses the columns; selected rows can be copied as
/// text.
class StatisticsPanel : public Panel {
    Q_OBJECT

public:
    explicit StatisticsPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }
    [[nodiscard]] const LiveStatistics& statistics() const { return m_statistics; }
    /// The selected rows, or all rows if none is selected, below a line of headings. Columns and
    /// rows are those shown, in their order, separated by tabs. Numbers have as many digits as in
    /// an exported table.
    [[nodiscard]] QString asText() const;

Q_SIGNALS:
    /// The user asks for an export of the statistics.
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
