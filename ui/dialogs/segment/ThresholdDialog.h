// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/values/ThresholdSegment.h"
#include "ui/dialogs/segment/SegmentDialog.h"

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class HistogramRange;
class IntervalSuggestions;
class ThresholdTrial;

/// Asks for the interval of values that a segment is made of, and shows in all views what becomes
/// of it meanwhile. It stays open beside the window, so that one looks at the result and tries
/// another interval.
class ThresholdDialog : public SegmentDialog {
    Q_OBJECT

public:
    explicit ThresholdDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment: with the interval that the segment follows and its limits, else
    /// with the interval of the last time in this study.
    void ask(int label);

    void setVisible(bool visible) override;

private:
    void build();
    void showState() override;
    void takeFollowed(); ///< what the segment follows, if it does
    void follow(); ///< the trial shows what is chosen
    void carryOut();
    void limitEditing(); ///< to the values of the interval
    [[nodiscard]] std::optional<core::ThresholdSegment> followed() const;
    [[nodiscard]] core::ThresholdSegment chosen() const;

    ThresholdTrial* m_trial;
    bool m_isFresh = true; ///< no interval was chosen in this study
    /// That of the interval which is followed; none: the clip box.
    std::optional<core::GrowBox> m_itsBox;
    QLabel* m_follows = nullptr; ///< says that it does
    HistogramRange* m_range = nullptr;
    IntervalSuggestions* m_suggestions = nullptr;
    QComboBox* m_mode = nullptr;
    QCheckBox* m_overwrite = nullptr;
    QCheckBox* m_onlyVisible = nullptr;
    QCheckBox* m_boxed = nullptr;
    QCheckBox* m_preview = nullptr;
    QLabel* m_now = nullptr; ///< how much the segment is
    QPushButton* m_limit = nullptr;
    QPushButton* m_apply = nullptr;
};

} // namespace ui
