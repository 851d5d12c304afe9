// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/repair/SeriesFindings.h"

#include <QFrame>

#include <vector>

class QButtonGroup;
class QComboBox;
class QLabel;

namespace ui {

/// Shows one finding of the series doctor: what was found, and a choice of repairs, the first of
/// which is to leave it as it is.
class FindingBox : public QFrame {
    Q_OBJECT

public:
    /// @param canChoose whether the study is available, so that another choice can be opened
    FindingBox(const core::SeriesFinding& finding, bool canChoose, QWidget* parent = nullptr);

    /// The chosen repair; null for none.
    [[nodiscard]] const core::RepairOffer* chosen() const;
    /// Chooses: 0 for none, n for the n-th repair.
    void choose(int choice);

Q_SIGNALS:
    void chosenChanged();

private:
    void buildText(const core::VolumeProblem& problem);
    void buildChoices(bool canChoose);
    void showEffect();

    core::SeriesFinding m_finding;
    int m_choice = 0;
    QButtonGroup* m_buttons = nullptr; ///< used for few repairs
    QComboBox* m_list = nullptr; ///< used for many
    QLabel* m_effect = nullptr;
};

} // namespace ui
