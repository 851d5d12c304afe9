// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/history/History.h"
#include "ui/tasks/LabelFetch.h"

#include <QDialog>
#include <QTimer>

#include <cstdint>
#include <optional>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace ui {

class FittingLabel;
class Workspace;

/// Asks from which size on the islands of a segment become segments of their own, and says how many
/// these are. It stays open beside the window and follows the segment. The labels are read by the
/// engine and looked through on another thread.
class SplitIslandsDialog : public QDialog {
    Q_OBJECT

public:
    explicit SplitIslandsDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    void ask(int label);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void look();
    void count(const LabelFetch::Planes& planes);
    void forget();
    void showState();
    void carryOut();
    [[nodiscard]] core::SplitIslands chosen() const;

    Workspace& m_workspace;
    int m_label = 0;
    /// Voxels of each island, from the largest down; none: they are being counted, or cannot be.
    std::optional<std::vector<std::int64_t>> m_sizes;
    bool m_looking = false;
    std::optional<core::RowId> m_position; ///< of the history, at which it was looked
    FittingLabel* m_whose;
    QDoubleSpinBox* m_mm3;
    QLabel* m_result;
    QPushButton* m_apply;
    QTimer m_lookSoon; ///< after several changes once
    LabelFetch m_fetch;
    core::Background m_counting; ///< last: its results are delivered to all of the above
};

} // namespace ui
