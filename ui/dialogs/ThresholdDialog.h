// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/values/ThresholdSegment.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class FittingLabel;
class HistogramRange;
class IntervalSuggestions;
class ThresholdTrial;
class Workspace;

/// Asks for the interval of values that a segment is made of, and shows in all views what becomes
/// of it meanwhile. It stays open beside the window, so that one looks at the result and tries
/// another interval.
class ThresholdDialog : public QDialog {
    Q_OBJECT

public:
    explicit ThresholdDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment. The interval stays that of the last time in this study.
    void ask(int label);

    void setVisible(bool visible) override;

private:
    void build();
    void showState();
    void follow(); ///< the trial shows what is chosen
    void carryOut();
    void limitEditing(); ///< to the values of the interval
    [[nodiscard]] core::ThresholdSegment chosen() const;

    Workspace& m_workspace;
    ThresholdTrial* m_trial;
    int m_label = 0;
    bool m_isFresh = true; ///< no interval was chosen in this study
    FittingLabel* m_whose = nullptr;
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
