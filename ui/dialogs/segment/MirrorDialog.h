// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/MirrorSegment.h"
#include "ui/dialogs/segment/SegmentDialog.h"

class QCheckBox;
class QComboBox;

namespace ui {

class PreviewRow;
class SegmentWorkRow;

/// Mirrors a segment about the middle of the images or about the crosshair, which it follows. The
/// segment becomes its mirror image or, if it is kept, gets that as well. The dialog stays open
/// beside the window, and all views preview the result.
class MirrorDialog : public SegmentDialog {
    Q_OBJECT

public:
    explicit MirrorDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Opens the dialog for a segment. What was chosen last is still chosen.
    void ask(int label);

private:
    void showState() override;
    void follow(); ///< updates the preview to what is chosen
    void carryOut();
    [[nodiscard]] core::MirrorSegment chosen() const;

    QComboBox* m_sides;
    QComboBox* m_place;
    QCheckBox* m_keep;
    PreviewRow* m_preview;
    SegmentWorkRow* m_work;
};

} // namespace ui
