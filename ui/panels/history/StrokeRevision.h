// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QObject>

class QWidget;

namespace ui {

class Workspace;

/// Revises strokes of the history: changes one, removes it, and offers to drill later ones again if
/// the change took away the surface from which they started.
class StrokeRevision : public QObject {
    Q_OBJECT

public:
    StrokeRevision(Workspace& workspace, QWidget* parent);

    /// Whether a row is a stroke that is part of the present state.
    [[nodiscard]] bool canRevise(core::RowId row) const;
    [[nodiscard]] bool isRemoved(core::RowId row) const;
    /// Asks for the new parameters and revises the stroke.
    void change(core::RowId row);
    void remove(core::RowId row);
    /// Restores the stroke as it was before it was removed.
    void restore(core::RowId row);

private:
    void apply(const core::Edit& edit);
    void offerRedrill();
    void redrill(const std::vector<core::RowId>& rows);

    Workspace& m_workspace;
    QWidget* m_window;
    core::RowId m_offered = 0; ///< the revision for which it was offered
};

} // namespace ui
