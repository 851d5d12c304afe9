// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"
#include "ui/tasks/trials/SplitTrial.h"

#include <QTimer>

#include <vector>

class QGridLayout;
class QPushButton;

namespace ui {

class FittingLabel;
class NumberField;
class Workspace;
struct SegmentAction;

/// Buttons that clean up the active segment as a whole: holes, islands, splitting, smoothing,
/// margin. They do the same as entries of the menu Segments, and tell in the same words why they
/// cannot. Below them stands which voxels may change (the editable range). While the cutting plane
/// is shown, a line tells the volumes of both parts into which it would split the segment. Hidden
/// without a segment.
class CleanUpPanel : public Panel {
    Q_OBJECT

public:
    explicit CleanUpPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    /// The active segment's name.
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool hasSomething() const override;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Button {
        QPushButton* button;
        const SegmentAction* action; ///< one of segmentActions(), which live as long as the program
    };
    void refresh();
    void setUpParts(QGridLayout& grid);
    /// Has both parts counted that the plane would make of the active segment.
    void lookAtParts();
    void showParts();
    /// Enables the possible buttons; tool tips of the others say why they are disabled.
    void showPossible();
    /// Runs an action for the active segment, with the size that the field asks for.
    void run(const SegmentAction& action);

    Workspace& m_workspace;
    /// What is a small island: as is usual for the active segment until it is set by hand.
    NumberField* m_smallMm3 = nullptr;
    bool m_isSetByHand = false;
    std::vector<Button> m_buttons;
    FittingLabel* m_parts = nullptr; ///< of the split by the plane
    QTimer m_lookSoon; ///< joins what happens at once
    SplitTrial m_trial;
    QString m_summary;
    bool m_hadSomething = false;
};

} // namespace ui
