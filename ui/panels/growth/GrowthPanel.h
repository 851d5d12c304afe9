// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "ui/frame/Panel.h"

#include <cstdint>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QLayout;
class QPushButton;

namespace ui {

class GenerationSection;
class GrowCriteriaSection;
class GrowthGhost;
class GrowthRun;
class HistogramRange;
class LeakSection;
class LiveInterval;
class PinholeOffer;
class PreviewBox;
class SeedBand;
class SeedInterval;
class Workspace;

/// The panel of region growing (seed A §5): the interval, and buttons like those of a media player.
/// What the user lets run is a GrowthRun; a single step is one step of undo, too.
class GrowthPanel : public Panel {
    Q_OBJECT

public:
    explicit GrowthPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;

    /// The edit that the settings describe, of the segments that begin (GrowthTurns.h).
    [[nodiscard]] core::GrowSteps growEdit() const;
    [[nodiscard]] bool running() const;

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
    [[nodiscard]] QLayout* buildGhost();
    void followGhost();
    void followInterval();
    void settleInterval();
    void shrink(std::optional<int> steps);

    Workspace& m_workspace;
    GrowthRun* m_run = nullptr;
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
    QLabel* m_intervalChange = nullptr;
    GrowthGhost* m_ghost = nullptr;
    PreviewBox* m_ghostShown = nullptr;
    QLabel* m_ghostText = nullptr;
    QComboBox* m_connectivity = nullptr;
    QComboBox* m_pace = nullptr;
    QCheckBox* m_overwrite = nullptr;
    QLabel* m_advice = nullptr;
    QLabel* m_turnsText = nullptr;
    PinholeOffer* m_pinholes = nullptr;
    LeakSection* m_leak = nullptr;
    QLabel* m_progress = nullptr;
    GenerationSection* m_generations = nullptr;
    std::vector<std::uint32_t> m_fronts; ///< front sizes of the last burst that was watched
};

} // namespace ui
