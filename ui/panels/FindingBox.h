// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/repair/SeriesFindings.h"

#include <QFrame>

#include <vector>

class QButtonGroup;
class QComboBox;
class QLabel;

namespace ui {

/// One finding of the series doctor: what was found, and what can be done about it as choices, the
/// first of which is to leave it as it is.
class FindingBox : public QFrame {
    Q_OBJECT

public:
    /// @param canChoose whether the study is at hand, so that another choice can be opened
    FindingBox(const core::SeriesFinding& finding, bool canChoose, QWidget* parent = nullptr);

    /// Null: as it is.
    [[nodiscard]] const core::RepairOffer* chosen() const;
    /// 0: as it is; the offers follow.
    void choose(int choice);

Q_SIGNALS:
    void chosenChanged();

private:
    void buildText(const core::VolumeProblem& problem);
    void buildChoices(bool canChoose);
    void showEffect();

    core::SeriesFinding m_finding;
    int m_choice = 0;
    QButtonGroup* m_buttons = nullptr; ///< of few offers
    QComboBox* m_list = nullptr; ///< of many
    QLabel* m_effect = nullptr;
};

} // namespace ui
