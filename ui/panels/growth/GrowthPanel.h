// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/growth/GrowthProgress.h"
#include "ui/frame/Panel.h"
#include "ui/panels/growth/GrowthTurns.h"

#include <QTimer>

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class GenerationSection;
class GrowCriteriaSection;
class HistogramRange;
class LeakSection;
class LiveInterval;
class SeedBand;
class SeedInterval;
class Workspace;

/// The panel of region growing (seed A §5): the interval, and buttons like those of a media player.
/// A burst lasts from pressing play to pause or closure and is one step of undo; so is a single
/// step.
class GrowthPanel : public Panel {
    Q_OBJECT

public:
    explicit GrowthPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;

    /// The edit that the settings describe, of the segments that begin (GrowthTurns.h); the buttons
    /// add the number of steps.
    [[nodiscard]] core::GrowSteps growEdit() const;
    [[nodiscard]] bool running() const { return m_running; }

public Q_SLOTS:
    void step();
    void playOrPause();
    void runToClosure();
    void resume();
    void shrinkStep();
    void shrinkToSeeds();

private:
    void build();
    void showVolume();
    void takeRecentCriteria();
    void showSettings();
    void takeSettings();
    void showState();
    void poll();
    [[nodiscard]] core::GrowSteps growEdit(const GrowthTurn& turn) const;
    void beginTurns(std::vector<GrowthTurn> turns, double generationsPerSecond);
    void goOn();
    bool begin(const core::Edit& growth, double generationsPerSecond);
    void followInterval();
    void settleInterval();
    void shrink(std::optional<int> steps);
    void finish();

    Workspace& m_workspace;
    SeedBand* m_band = nullptr;
    HistogramRange* m_range = nullptr;
    GrowCriteriaSection* m_criteria = nullptr;
    SeedInterval* m_fromSeeds = nullptr;
    QPushButton* m_step = nullptr;
    QPushButton* m_play = nullptr;
    QPushButton* m_toClosure = nullptr;
    QPushButton* m_shrink = nullptr;
    QPushButton* m_toSeeds = nullptr;
    QPushButton* m_resume = nullptr;
    QCheckBox* m_live = nullptr;
    LiveInterval* m_liveInterval = nullptr;
    QComboBox* m_connectivity = nullptr;
    QComboBox* m_pace = nullptr;
    QCheckBox* m_overwrite = nullptr;
    QLabel* m_advice = nullptr;
    QLabel* m_turnsText = nullptr;
    LeakSection* m_leak = nullptr;
    QLabel* m_progress = nullptr;
    GenerationSection* m_generations = nullptr;
    QTimer m_watch; ///< only updates what is shown; has no influence on voxels
    std::vector<std::uint32_t> m_fronts; ///< front sizes of the last burst that was watched
    bool m_running = false;
    std::vector<GrowthTurn> m_turns; ///< the one that grows, or raised an alarm, and those after it
    bool m_nextTurn = false; ///< the first of them begins as soon as the session is idle
    std::size_t m_mostRows = 0; ///< that there may be when the next turn begins
    double m_turnPace = 0.0; ///< generations per second; 0: as fast as it goes
};

} // namespace ui
