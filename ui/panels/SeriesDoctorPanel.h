// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/repair/SeriesFindings.h"
#include "ui/frame/Panel.h"

#include <vector>

class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace ui {

class FindingBox;
class Workspace;

/// What was found about the open series, and what can be done about it on opening it anew: its
/// files stay as they are, and every choice can be taken back. Of a series in time also which point
/// is open. There only while there is something to say.
class SeriesDoctorPanel : public Panel {
    Q_OBJECT

public:
    explicit SeriesDoctorPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }
    [[nodiscard]] bool hasSomething() const override;

Q_SIGNALS:
    /// Another choice is to be opened in place of what is open. @param series as loadVolume() takes
    /// it
    void reopenAsked(const QString& path, const QString& series);

private:
    void build();
    void showVolume();
    void showChoice();
    void showTimes();
    void apply();
    void openTime();
    /// Another stack that was chosen; null: none.
    [[nodiscard]] const core::RepairOffer* otherStack() const;
    /// All that was chosen, as `--repair` takes it.
    [[nodiscard]] QString chosenRepair() const;

    Workspace& m_workspace;
    std::vector<FindingBox*> m_boxes;
    QVBoxLayout* m_list = nullptr;
    QWidget* m_decision = nullptr;
    QLabel* m_now = nullptr;
    QLabel* m_after = nullptr;
    QLabel* m_note = nullptr;
    QPushButton* m_apply = nullptr;
    QWidget* m_times = nullptr;
    QLabel* m_timeText = nullptr;
    QSlider* m_time = nullptr;
    QPushButton* m_openTime = nullptr;
};

} // namespace ui
