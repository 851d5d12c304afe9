// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QComboBox;

namespace ui {

class Workspace;

/// A list in the option bar that chooses the segment on which a tool works.
class SeedOptions : public QWidget {
    Q_OBJECT

public:
    /// @param label in front of the list; may be empty
    SeedOptions(Workspace& workspace, const QString& label, QWidget* parent = nullptr);

private:
    void showSegments();
    void takeSegment(int row);

    Workspace& m_workspace;
    QComboBox* m_segments = nullptr;
};

} // namespace ui
