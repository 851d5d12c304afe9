// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/GrowBox.h"
#include "ui/dialogs/segment/SegmentDialog.h"

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace core {
struct ThresholdSegment;
}

namespace ui {

class EditTrial;
class HistogramRange;
class IntervalSuggestions;
class PreviewBox;

/// Sets a segment to the voxels whose values lie in an interval, or adds or removes these voxels.
/// While it is open, all views preview the result (EditTrial). It stays open beside the
/// window, so the user can look at the result and try another interval.
class ThresholdDialog : public SegmentDialog {
    Q_OBJECT

public:
    explicit ThresholdDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Opens the dialog for a segment. If the segment follows an interval, the dialog starts with
    /// that interval and its limits; otherwise with the interval that was used last in this study.
    void ask(int label);

    void setVisible(bool visible) override;

private:
    void build();
    void showState() override;
    void takeFollowed(); ///< shows the interval that the segment follows, if any
    void follow(); ///< updates the preview to what is chosen
    void carryOut();
    void limitEditing(); ///< makes the interval the editable range of all tools
    [[nodiscard]] std::optional<core::ThresholdSegment> followed() const;
    [[nodiscard]] core::ThresholdSegment chosen() const;

    EditTrial* m_trial;
    bool m_isFresh = true; ///< no interval was chosen in this study yet
    /// The box of the interval that the segment follows; none: limiting to a box means the clip
    /// box.
    std::optional<core::GrowBox> m_itsBox;
    QLabel* m_follows = nullptr; ///< says that the segment follows its interval
    HistogramRange* m_range = nullptr;
    IntervalSuggestions* m_suggestions = nullptr;
    QComboBox* m_mode = nullptr;
    QCheckBox* m_overwrite = nullptr;
    QCheckBox* m_onlyVisible = nullptr;
    QCheckBox* m_boxed = nullptr;
    PreviewBox* m_preview = nullptr;
    QLabel* m_now = nullptr; ///< the segment's size, in the preview and at present
    QPushButton* m_limit = nullptr;
    QPushButton* m_apply = nullptr;
};

} // namespace ui
