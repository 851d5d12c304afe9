// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/CleanSegment.h"
#include "ui/frame/Panel.h"
#include "ui/tasks/trials/SplitTrial.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

class QGridLayout;
class QPushButton;

namespace ui {

class FittingLabel;
class NumberField;
class PointedPreview;
class PreviewRow;
class Workspace;
struct SegmentAction;

/// Buttons that clean up the active segment as a whole: holes, islands, splitting, smoothing,
/// margin. They do the same as entries of the menu Segments, and tell in the same words why they
/// cannot. While the pointer rests on one that fills holes or takes islands away, all views preview
/// what it would do, and a row below tells how many millilitres and voxels that is. Below it stands
/// which voxels may change (the editable range). While the cutting plane is shown, a line tells the
/// volumes of both parts into which it would split the segment. Hidden without a segment.
class CleanUpPanel : public Panel {
    Q_OBJECT

public:
    explicit CleanUpPanel(Workspace& workspace, QWidget* parent = nullptr);
    ~CleanUpPanel() override;

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
    void setUpPreview(QGridLayout& grid);
    void setUpParts(QGridLayout& grid);
    void followPreview();
    /// The edit of a button that can be previewed, for the active segment and with the size that
    /// the field asks for; none: it is another button's action.
    [[nodiscard]] std::optional<core::CleanSegment> cleaningOf(const SegmentAction& action) const;
    /// Has both parts counted that the plane would make of the active segment.
    void lookAtParts();
    void showParts();
    /// Enables the possible buttons; tool tips of the others say why they are disabled.
    void showPossible();
    /// Runs an action for the active segment. What is previewed of it is taken as it is.
    void run(const SegmentAction& action);

    Workspace& m_workspace;
    /// What is a small island: as is usual for the active segment until it is set by hand.
    NumberField* m_smallMm3 = nullptr;
    bool m_isSetByHand = false;
    std::vector<Button> m_buttons;
    PreviewRow* m_preview = nullptr;
    FittingLabel* m_parts = nullptr; ///< of the split by the plane
    QTimer m_lookSoon; ///< joins what happens at once
    SplitTrial m_trial;
    QString m_summary;
    bool m_hadSomething = false;
    std::unique_ptr<PointedPreview> m_pointed; ///< last: it has the others look
};

} // namespace ui
