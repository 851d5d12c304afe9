// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/volume/ClipRegion.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// What a user changed of the clip region since the last step of the history. Clipping is a way of
/// looking and no step of the session, but whoever presses undo right after a clip means the clip.
/// Once the history goes on, or the clip comes from somewhere else (another study, a bookmark),
/// these steps are forgotten. Part of Workspace.
class ClipSteps : public QObject {
    Q_OBJECT

public:
    explicit ClipSteps(Workspace& workspace);

    /// The user clips. Changes that follow one another without a rest are one step.
    void change(const core::ClipRegion& clip);
    /// All changes until release() are one step, with or without rests: a drag.
    void hold();
    void release();
    /// Ends a drag as if it had never been.
    void cancelHold();

    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    void undo();
    void redo();

private:
    [[nodiscard]] std::optional<core::RowId> position() const;
    void go(std::vector<core::ClipRegion>& from, std::vector<core::ClipRegion>& to);
    void closeStep();
    void forget();

    Workspace& m_workspace;
    std::vector<core::ClipRegion> m_before; ///< each step's, oldest first
    std::vector<core::ClipRegion> m_after; ///< of those undone, the last undone at the end
    std::optional<core::RowId> m_position; ///< of the history, when the steps were made
    bool m_open = false; ///< the next change goes on with the last step
    bool m_held = false;
    bool m_own = false; ///< the clip is being changed here
    QTimer m_rest;
};

} // namespace ui
