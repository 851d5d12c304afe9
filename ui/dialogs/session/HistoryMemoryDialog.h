// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QSpinBox;

namespace ui {

class Workspace;

/// Asks how much memory the history may take. On OK this becomes the setting, and the open session
/// applies it at once.
class HistoryMemoryDialog : public QDialog {
    Q_OBJECT

public:
    explicit HistoryMemoryDialog(Workspace& workspace, QWidget* parent = nullptr);

    void accept() override;

private:
    Workspace& m_workspace;
    QSpinBox* m_mebibytes = nullptr;
};

} // namespace ui
