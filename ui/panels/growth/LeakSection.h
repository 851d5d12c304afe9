// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/growth/GrowthCommands.h"
#include "core/history/History.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;

namespace ui {

class Workspace;
struct GrowthTurn;

/// The leak guard in the growth panel: whether growth stops where its front bursts out of a narrow
/// place and, after it has stopped, what to do; and whether barriers are shown.
class LeakSection : public QWidget {
    Q_OBJECT

public:
    explicit LeakSection(Workspace& workspace, QWidget* parent = nullptr);

    /// Offers the choices for the alarm of the last growth; none: no alarm any more.
    void showAlarm(const std::optional<core::LeakAlarm>& alarm);
    /// The same for the alarm of a burst that may be no row yet.
    void showAlarmOf(const core::LeakAlarm& alarm, const GrowthTurn& burst);

Q_SIGNALS:
    /// @param plane the label plane of the growth that is to go on
    void goOnRequested(std::uint8_t plane);
    /// Handles that the growth that was watched last is not continued: its alarm was rejected, or
    /// another growth has one.
    void growthLeft();
    /// The alarm about which the user is to decide, while the growth that raised it is shown; none:
    /// there is none.
    void alarmChanged(const std::optional<core::LeakAlarm>& alarm);

private:
    void showSettings();
    void takeSettings();
    void showBarriers();
    void follow();
    void offer(const std::optional<core::LeakAlarm>& alarm);
    void endOffer();
    /// Shows the alarm beside its growth, and hides it beside others.
    void showBesideGrowth();
    void showPlace();
    /// Shows by how much a front must be wider before growth asks, if that is more than the fields
    /// say.
    void showRaised();
    void askAsBefore();
    /// The segments of the growth that raised the alarm.
    [[nodiscard]] std::vector<int> alarmedLabels() const;
    void accept();
    void reject();
    void plug();
    void apply(const core::Edit& edit);

    Workspace& m_workspace;
    QCheckBox* m_guard = nullptr;
    QDoubleSpinBox* m_factor = nullptr;
    QDoubleSpinBox* m_area = nullptr;
    QCheckBox* m_barriers = nullptr;
    QWidget* m_offer = nullptr;
    QLabel* m_text = nullptr;
    QLabel* m_raised = nullptr;
    std::optional<core::LeakAlarm> m_alarm;
    std::uint8_t m_plane = 0; ///< the label plane of the growth that raised it
    /// The segments of the burst that raised it; none: they follow from the row of the last growth.
    std::optional<std::vector<int>> m_grew;
    bool m_stands = false; ///< the growth has reached the alarm's generation
    std::optional<core::LeakAlarm> m_answered; ///< before its growth was a row
    core::RowId m_shownGrowth = 0; ///< the last growth whose alarm was shown
};

} // namespace ui
