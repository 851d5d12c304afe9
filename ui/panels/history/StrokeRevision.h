// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QObject>

class QWidget;

namespace ui {

class Workspace;

/// Strokes of the history as objects: changes one, removes it, and offers to draw later ones anew
/// where the change took their surface away.
class StrokeRevision : public QObject {
    Q_OBJECT

public:
    StrokeRevision(Workspace& workspace, QWidget* parent);

    /// Whether a row is a stroke that counts now.
    [[nodiscard]] bool canRevise(core::RowId row) const;
    [[nodiscard]] bool isRemoved(core::RowId row) const;
    /// Asks how it is to be.
    void change(core::RowId row);
    void remove(core::RowId row);
    /// As it was drawn.
    void restore(core::RowId row);

private:
    void apply(const core::Edit& edit);
    void offerRedrill();
    void redrill(const std::vector<core::RowId>& rows);

    Workspace& m_workspace;
    QWidget* m_window;
    core::RowId m_offered = 0; ///< the revision that it was offered for
};

} // namespace ui
