// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/repair/SeriesFindings.h"
#include "ui/frame/Panel.h"

#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui {

class FindingBox;
class TimeSlider;
class Workspace;

/// The series doctor: shows what was found in the open series, and repairs with which it can be
/// opened again. The files stay as they are, and every choice can be taken back. For a time series
/// it also chooses the point in time. Hidden while there is nothing to say.
class SeriesDoctorPanel : public Panel {
    Q_OBJECT

public:
    explicit SeriesDoctorPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }
    [[nodiscard]] bool hasSomething() const override;
    [[nodiscard]] TimeSlider& times() const { return *m_times; }

Q_SIGNALS:
    /// The user wants to open the series with another choice.
    /// @param series as loadVolume() takes it
    void reopenRequested(const QString& path, const QString& series);

private:
    void build();
    void showVolume();
    void showChoice();
    void apply();
    /// The other stack that was chosen; null if none was.
    [[nodiscard]] const core::RepairOffer* otherStack() const;
    /// All chosen repairs, as `--repair` takes them.
    [[nodiscard]] QString chosenRepair() const;

    Workspace& m_workspace;
    std::vector<FindingBox*> m_boxes;
    QVBoxLayout* m_list = nullptr;
    QWidget* m_decision = nullptr;
    QLabel* m_now = nullptr;
    QLabel* m_after = nullptr;
    QLabel* m_note = nullptr;
    QPushButton* m_apply = nullptr;
    TimeSlider* m_times = nullptr;
};

} // namespace ui
