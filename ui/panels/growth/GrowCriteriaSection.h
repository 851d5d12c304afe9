// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/AxisSliders.h"
#include "ui/settings/growth/GrowSettings.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace ui {

class FoldButton;
class SeedBand;
class Workspace;

/// The name of GrowSettings::smoothing, wherever the panel speaks of it.
[[nodiscard]] QString smoothNoiseName();

/// The part of the growth panel for the limits of a growth besides its interval: one row per limit,
/// with a tick and its value. Below them is a choice whether the 3D view shows what an interval
/// suspends. Folded, it is one line that states how many limits are on.
class GrowCriteriaSection : public QWidget {
    Q_OBJECT

public:
    /// @param band outlives the section
    GrowCriteriaSection(Workspace& workspace, const SeedBand& band, QWidget* parent = nullptr);

private:
    /// A limit with a value.
    struct Row {
        GrowSettings::Limit GrowSettings::*limit = nullptr;
        QCheckBox* on = nullptr;
        QDoubleSpinBox* value = nullptr; ///< mm from the low side of the volume
    };

    void build();
    void addRow(GrowSettings::Limit GrowSettings::*limit, const char* name, const QString& text,
        const QString& tip);
    QCheckBox* addSwitch(const char* name, const QString& text, const QString& tip);
    void buildBox();
    void buildSuspended();
    void showVolume();
    void showSettings();
    void showBand();
    void showSuspended();
    void takeSuspended(bool shown);
    void change(const Row& row);
    void takeSwitches();
    void takeAxis(int axis, double lower, double upper);
    void setBox(const core::ClipRegion::Box& box);
    [[nodiscard]] core::ClipRegion::Box boxAround(const glm::dvec3& placeLps) const;
    /// A box around the seeds of the active segment; none if it has none.
    [[nodiscard]] std::optional<core::ClipRegion::Box> boxAroundSeeds() const;

    Workspace& m_workspace;
    const SeedBand& m_band;
    FoldButton* m_fold = nullptr;
    QWidget* m_body = nullptr;
    QLabel* m_bandText = nullptr;
    std::vector<Row> m_rows;
    QCheckBox* m_smoothing = nullptr;
    QCheckBox* m_onlyVisible = nullptr;
    QCheckBox* m_boxed = nullptr;
    QToolButton* m_setBox = nullptr;
    QWidget* m_boxBody = nullptr;
    AxisSliders m_axes; ///< of the box
    QCheckBox* m_suspended = nullptr;
};

} // namespace ui
