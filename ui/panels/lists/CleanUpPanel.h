// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

#include <vector>

class QPushButton;

namespace ui {

class Workspace;
struct SegmentAction;

/// What tidies the active segment as a whole, as buttons: holes, islands, splitting, smoothing,
/// margin. They do what the entries of the menu Segments do, and say as these do why they cannot.
/// Without a segment the panel takes no room.
class CleanUpPanel : public Panel {
    Q_OBJECT

public:
    explicit CleanUpPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    /// Whose voxels it is about.
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool hasSomething() const override;

private:
    struct Button {
        QPushButton* button;
        const SegmentAction* action; ///< of segmentActions(), which stand as long as the program
    };
    void refresh();
    void showPossible(); ///< which buttons can be pressed, and why others cannot

    Workspace& m_workspace;
    std::vector<Button> m_buttons;
    QString m_summary;
    bool m_hadSomething = false;
};

} // namespace ui
