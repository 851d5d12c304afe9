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

/// The user's changes to what is shown since the last step of the history: the clip region, and
/// which segments are visible. Both are ways of viewing and no steps of the session, but a user who
/// presses undo right after hiding something means that. These steps are forgotten when the history
/// goes on, or when something else sets the clip region (another study, a bookmark). Part of
/// Workspace.
class ViewSteps : public QObject {
    Q_OBJECT

public:
    /// What a step has changed.
    enum class What { Clip, Segments };

    explicit ViewSteps(Workspace& workspace);

    /// Sets the clip region for the user. Changes that follow one another without a pause are one
    /// step.
    void change(const core::ClipRegion& clip);
    /// Makes all changes until release() one step, with or without pauses: a drag.
    void hold();
    void release();
    /// Ends a drag and restores the clip region from before it.
    void cancelHold();

    /// Shows or hides a segment for the user. However long the pauses between them are, such
    /// changes are one step until something else is done; if they come to nothing, none.
    void showSegment(int label, bool shown);
    /// Shows one segment alone; if it is alone already, the others again that were shown before, or
    /// all of them if that is not known.
    void showAlone(int label);
    /// Whether showAlone() would show others again, and not simply all.
    [[nodiscard]] bool knowsOthers(int label) const;

    /// What undo() and redo() would change; none: they can do nothing.
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
        Shown shown; ///< before the step, or, of an undone one, after it
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
    std::vector<Step> m_after; ///< the last undone at the end
    std::optional<core::RowId> m_position; ///< position of the history when the steps were made
    std::optional<What> m_open; ///< such a change belongs to the last step
    /// What was hidden before one segment was shown alone; none: nobody did that since.
    std::optional<std::vector<int>> m_hiddenBeforeAlone;
    bool m_held = false;
    bool m_own = false; ///< what is shown is being changed by this object
    QTimer m_rest;
};

/// Whether this segment is shown and no other one.
[[nodiscard]] bool isShownAlone(const core::Document& document, int label);

} // namespace ui
