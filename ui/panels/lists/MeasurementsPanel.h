// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "ui/frame/Panel.h"

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace ui {

class Workspace;

/// The list of measurements and notes. A click puts the crosshair on one; Del removes the selected
/// ones, each as a step that can be undone. All of them can be saved as a table.
class MeasurementsPanel : public Panel {
    Q_OBJECT

public:
    explicit MeasurementsPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool hasSomething() const override;
    /// Writes all measurements whose values are known as a CSV table. An existing file is replaced.
    void saveAs(const QString& file);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void fitHeight();
    void lead(const QListWidgetItem* item);
    void removeSelected();
    void save();

    Workspace& m_workspace;
    QListWidget* m_list = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_remove = nullptr;
    bool m_hadSomething = false;
    core::Background m_background; ///< writes the table
};

} // namespace ui
