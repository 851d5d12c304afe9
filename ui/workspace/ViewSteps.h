// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/history/History.h"
#include "core/volume/ClipRegion.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Undo for changes of what is shown since the last step of the history: the clip region, and which
/// segments are visible. Both are ways of viewing and no steps of the session; but a user who
/// presses undo right after hiding something means that. These steps are forgotten when the history
/// goes on, or when something else sets the clip region (another study, a bookmark). Part of
/// Workspace. GUI thread.
class ViewSteps : public QObject {
    Q_OBJECT

public:
    /// What a step changes.
    enum class What { Clip, Segments };

    explicit ViewSteps(Workspace& workspace);

    /// Sets the clip region for the user. Changes without a pause between them are one step.
    void change(const core::ClipRegion& clip);
    /// Starts a drag: all changes until release() are one step, whatever the pauses.
    void hold();
    void release();
    /// Aborts a drag and restores the clip region from before it.
    void cancelHold();

    /// Shows or hides a segment for the user. All such changes are one step until something else is
    /// done, whatever the pauses. If they cancel each other out, there is no step.
    void showSegment(int label, bool shown);
    /// Shows only one segment. If only this one is shown already, shows the others again that were
    /// shown before, or all segments if that is not known.
    void showAlone(int label);
    /// Whether showAlone() would restore the segments that were shown before, and not simply show
    /// all.
    [[nodiscard]] bool knowsOthers(int label) const;

    /// What undo() and redo() would change; none: nothing.
    [[nodiscard]] std::optional<What> undoable() const;
    [[nodiscard]] std::optional<What> redoable() const;
    void undo();
    void redo();

private:
    /// What was shown at one moment.
    struct Shown {
        core::ClipRegion clip;
        std::vector<int> hidden; ///< labels, ascending
    };
    struct Step {
        What what = What::Clip;
        Shown shown; ///< state before the step; for an undone step, after it
    };
    [[nodiscard]] std::optional<core::RowId> position() const;
    [[nodiscard]] Shown shown() const;
    void show(const Shown& wanted);
    void hideOnly(const std::vector<int>& hidden);
    void changeHidden(std::vector<int> hidden);
    void begin(What what);
    void go(std::vector<Step>& from, std::vector<Step>& to);
    void closeStep();
    void forget();

    Workspace& m_workspace;
    std::vector<Step> m_before; ///< oldest first
    std::vector<Step> m_after; ///< undone steps, the last undone at the end
    std::optional<core::RowId> m_position; ///< the history's position when the steps were made
    std::optional<What> m_open; ///< a change of this kind still belongs to the last step
    /// The labels that were hidden before showAlone(); none: it was not called since.
    std::optional<std::vector<int>> m_hiddenBeforeAlone;
    bool m_held = false;
    bool m_own = false; ///< this object itself is changing what is shown
    QTimer m_rest;
};

/// Whether this segment is the only one that is shown.
[[nodiscard]] bool isShownAlone(const core::Document& document, int label);

} // namespace ui
