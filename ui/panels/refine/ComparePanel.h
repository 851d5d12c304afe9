// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"
#include "ui/tasks/LiveComparison.h"

#include <QStringList>

#include <array>

class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class LookFirstSection;

/// Shows, while the user works, how far the surface that is being refined, or else the active
/// segment, is from a reference mask, which is read from a file, or is the mask that was imported:
/// relative volume error (seed B §7.3), Dice, distances, and what was added and taken. Above that,
/// the places of the active segment to look at first.
class ComparePanel : public Panel {
    Q_OBJECT

public:
    explicit ComparePanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }
    [[nodiscard]] LiveComparison& comparison() { return m_comparison; }
    [[nodiscard]] LookFirstSection& lookFirst() { return *m_lookFirst; }

private:
    void ask();
    void allow();
    void show();
    [[nodiscard]] QString whatIsCompared() const;

    Workspace& m_workspace;
    LiveComparison m_comparison;
    LookFirstSection* m_lookFirst = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_imported = nullptr;
    QComboBox* m_reference = nullptr;
    QStringList m_references; ///< what it lists
    QLabel* m_what = nullptr;
    QWidget* m_figures = nullptr; ///< hidden until there is a reference
    std::array<QLabel*, 6> m_values{}; ///< added, taken, relative volume error, Dice, 95 %, mean
};

} // namespace ui
