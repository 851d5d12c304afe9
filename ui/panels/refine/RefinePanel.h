// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "ui/frame/Panel.h"

#include <QTimer>

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;
class QSpinBox;

namespace ui {

class DoubtsSection;
class Workspace;

/// The panel of the surface that is being refined: here the user creates the surface and sets how
/// it looks; the panel lists what is marked as wrong, and says whether the segment holds what the
/// surface encloses.
class RefinePanel : public Panel {
    Q_OBJECT

public:
    explicit RefinePanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }

    /// Writes the surface to a file, in the format that its ending names; an existing file of that
    /// name is replaced.
    void save(const QString& path);

private:
    QWidget* buildLaying();
    QWidget* buildRefining();
    [[nodiscard]] QString asLaidText() const;
    void show();
    void showErrors();
    void takeLook();
    void watch();
    void askWhereToSave();

    Workspace& m_workspace;
    QWidget* m_laying = nullptr; ///< shown while there is no surface
    QWidget* m_refining = nullptr; ///< shown while there is one
    QLabel* m_whose = nullptr;
    QSpinBox* m_vertices = nullptr;
    QPushButton* m_lay = nullptr;
    QLabel* m_state = nullptr;
    QPushButton* m_write = nullptr;
    QPushButton* m_follow = nullptr;
    QPushButton* m_drop = nullptr;
    QComboBox* m_style = nullptr;
    QSlider* m_opacity = nullptr;
    QLabel* m_opacityText = nullptr;
    QCheckBox* m_marks = nullptr;
    QCheckBox* m_contours = nullptr;
    QLabel* m_counts = nullptr;
    QListWidget* m_errors = nullptr;
    QPushButton* m_signOff = nullptr;
    DoubtsSection* m_doubts = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_abort = nullptr; ///< while a surface is laid, follows, or fits a template
    QTimer m_watching;
    core::Background m_saver; ///< last: its results are delivered to all of the above
};

} // namespace ui
