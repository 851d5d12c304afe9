// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

#include <vector>

class QPushButton;

namespace ui {

class NumberField;
class Workspace;
struct SegmentAction;

/// Buttons that clean up the active segment as a whole: holes, islands, splitting, smoothing,
/// margin. They do the same as entries of the menu Segments, and tell in the same words why they
/// cannot. Hidden without a segment.
class CleanUpPanel : public Panel {
    Q_OBJECT

public:
    explicit CleanUpPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    /// The active segment's name.
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool hasSomething() const override;

private:
    struct Button {
        QPushButton* button;
        const SegmentAction* action; ///< one of segmentActions(), which live as long as the program
    };
    void refresh();
    /// Enables the possible buttons; tool tips of the others say why they are disabled.
    void showPossible();
    /// Runs an action for the active segment, with the size that the field asks for.
    void run(const SegmentAction& action);

    Workspace& m_workspace;
    /// What is a small island: as is usual for the active segment until it is set by hand.
    NumberField* m_smallMm3 = nullptr;
    bool m_isSetByHand = false;
    std::vector<Button> m_buttons;
    QString m_summary;
    bool m_hadSomething = false;
};

} // namespace ui
