// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QComboBox;
class QSpinBox;

namespace ui {

class Workspace;

/// The options of the chunk tool in the option bar: how many chunks there are, and which of them
/// the 3D view shows; always in step with Chunks::look().
class ChunkOptions : public QWidget {
    Q_OBJECT

public:
    explicit ChunkOptions(Workspace& workspace, QWidget* parent = nullptr);

private:
    void show();
    void take();

    Workspace& m_workspace;
    QSpinBox* m_count = nullptr;
    QComboBox* m_bodies = nullptr;
};

} // namespace ui
