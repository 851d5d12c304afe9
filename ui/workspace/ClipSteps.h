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

/// The user's changes to the clip region since the last step of the history. Clipping is a way of
/// viewing and not a step of the session, but a user who presses undo right after clipping means
/// the clip. These steps are forgotten when the history goes on, or when the clip region is set by
/// something else (another study, a bookmark). Part of Workspace.
class ClipSteps : public QObject {
    Q_OBJECT

public:
    explicit ClipSteps(Workspace& workspace);

    /// Sets the clip region for the user. Changes that follow one another without a pause are one
    /// step.
    void change(const core::ClipRegion& clip);
    /// Makes all changes until release() one step, with or without pauses: a drag.
    void hold();
    void release();
    /// Ends a drag and restores the clip region from before it.
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
    std::vector<core::ClipRegion> m_before; ///< the region before each step, oldest first
    /// The regions of undone steps, the last undone at the end.
    std::vector<core::ClipRegion> m_after;
    std::optional<core::RowId> m_position; ///< position of the history when the steps were made
    bool m_open = false; ///< the next change belongs to the last step
    bool m_held = false;
    bool m_own = false; ///< the clip region is being changed by this object
    QTimer m_rest;
};

} // namespace ui
