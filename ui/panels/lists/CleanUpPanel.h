// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/islands/SegmentIslands.h"
#include "ui/frame/Panel.h"
#include "ui/tasks/trials/SplitTrial.h"

#include <QTimer>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QGridLayout;
class QMenu;
class QPushButton;

namespace core {
struct CombineSegments;
struct Segment;
} // namespace core

namespace ui {

class FittingLabel;
class NumberField;
class PointedPreview;
class PreviewRow;
class Workspace;
struct SegmentAction;

/// Buttons that clean up the active segment as a whole: holes, islands, splitting, smoothing,
/// margin, inverting, and a menu that combines it with another one. They do the same as entries of
/// the menu Segments, and say in the same words why they cannot. While the pointer rests on one
/// that needs no dialog, or on an entry of that menu, all views preview what it would do, and a row
/// below shows how many millilitres and voxels that is. Below it the panel shows which voxels may
/// change (the editable range). While the cutting plane is shown, a line states the volumes of both
/// parts into which it would split the segment. Hidden without a segment.
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
    /// An action that can be previewed.
    struct Previewed {
        /// For the active segment and with what fields ask for; none: it cannot be done.
        std::function<std::optional<core::Edit>()> edit;
        /// Like the functions of SegmentActions.h whose edits may be previewed before.
        std::function<void(const core::Edit& edit, bool isOpen)> carryOut;
    };
    void refresh();
    void setUpButtons(QGridLayout& grid);
    void setUpCombine();
    void knowPreviewed();
    void setUpPreview(QGridLayout& grid);
    void setUpParts(QGridLayout& grid);
    void followPreview();
    [[nodiscard]] std::optional<core::Edit> cleaning(core::IslandRule rule) const;
    [[nodiscard]] std::optional<core::Edit> splitting() const;
    [[nodiscard]] std::optional<core::Edit> inverting() const;
    /// Null: there is no preview of it.
    [[nodiscard]] const Previewed* previewedOf(const SegmentAction& action) const;
    /// @param edit what an entry of the menu would do; null: none is pointed at
    void previewCombined(const core::CombineSegments* edit);
    void combine(const core::CombineSegments& edit);
    /// The segment whose size is shown: the active one, or the one into which it would be merged.
    [[nodiscard]] const core::Segment* sizedSegment() const;
    /// Starts counting both parts into which the plane would split the active segment.
    void lookAtParts();
    void showParts();
    /// Enables the possible buttons; tool tips of the others say why they are disabled.
    void showPossible();
    /// Runs an action for the active segment. What is previewed of it is taken as it is.
    void run(const SegmentAction& action);

    Workspace& m_workspace;
    /// Islands below this size count as small, mm³; it suits the active segment until the user sets
    /// it.
    NumberField* m_smallMm3 = nullptr;
    bool m_isSetByHand = false;
    std::vector<Button> m_buttons;
    QPushButton* m_combine = nullptr;
    QMenu* m_combineMenu = nullptr;
    std::map<QString, Previewed> m_previewed; ///< by the action's id
    int m_combined = 0; ///< label whose voxels an entry of the menu would change; 0: none
    bool m_showsSplit = false; ///< a segment that is not there yet is seen
    PreviewRow* m_preview = nullptr;
    FittingLabel* m_parts = nullptr; ///< of the split by the plane
    QTimer m_lookSoon; ///< joins changes that come together
    SplitTrial m_trial;
    QString m_summary;
    bool m_hadSomething = false;
    std::unique_ptr<PointedPreview> m_pointed; ///< last: it uses all of the above
};

} // namespace ui
