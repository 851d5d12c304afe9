// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/history/History.h"
#include "core/volume/ClipRegion.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Undo for changes of what is shown: the clip region, and which segments are visible. Both belong
/// to the view and are not steps of the session. So they do not end a running growth, do not begin
/// a new branch of the history when the user only looks around among undone steps, and also work in
/// a session that cannot be written. But a user who presses undo right after hiding something means
/// that, so each belongs to the row of the history at which it was made: undo takes it back before
/// that row, redo brings it back after it, and the list of the history shows it there. They are
/// forgotten with the session, and when something else sets the clip region. Part of Workspace. GUI
/// thread.
class ViewSteps : public QObject {
    Q_OBJECT

public:
    /// What a step changes.
    enum class What { Clip, Segments };
    /// A step, as it is named.
    struct Step {
        What what = What::Clip;
        std::vector<int> hidden{}; ///< labels of the segments that it hides, ascending
        std::vector<int> shown{}; ///< and of those that it shows
    };
    /// The steps that were made at one row of the history.
    struct Steps {
        std::vector<Step> all; ///< in the order in which they were made
        int done = 0; ///< how many of them are done; redo() would bring back the others
    };

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

    /// The row to which changes belong now: that at which the history stands, or will once the
    /// walks that are under way have arrived.
    [[nodiscard]] core::RowId position() const;
    /// What undo() and redo() would take back and bring back; none: nothing. While an edit is under
    /// way, what was done before it began is not next.
    [[nodiscard]] std::optional<Step> undoable() const;
    [[nodiscard]] std::optional<Step> redoable() const;
    void undo();
    void redo();
    /// Undoes or redoes until this many steps are done at position().
    void goTo(int done);

    /// @param row 0: the study as it was opened
    [[nodiscard]] Steps at(core::RowId row) const;
    /// How many steps there are at each row, done or not; rows without any are missing.
    [[nodiscard]] std::map<core::RowId, int> counts() const;

Q_SIGNALS:
    /// There are other steps, or others are done.
    void changed();

private:
    /// What was shown at one moment.
    struct Shown {
        core::ClipRegion clip;
        std::vector<int> hidden; ///< labels, ascending
    };
    struct Change {
        What what = What::Clip;
        bool isBeside = false; ///< an edit was under way
        Shown before;
        Shown after;
    };
    struct Walk {
        std::vector<Change> done; ///< oldest first
        std::vector<Change> undone; ///< the last undone at the end
    };
    [[nodiscard]] bool isEditing() const;
    [[nodiscard]] const Walk* here() const;
    [[nodiscard]] Shown shown() const;
    void hideOnly(const std::vector<int>& hidden);
    void changeHidden(std::vector<int> hidden);
    /// The change that what follows belongs to.
    Change& begin(What what);
    [[nodiscard]] static Step named(const Change& change);
    void show(const Change& change, const Shown& wanted);
    void takeBack();
    void closeStep();
    void forget();
    void followHistory();

    Workspace& m_workspace;
    std::map<core::RowId, Walk> m_walks; ///< by the row at which they were made
    std::size_t m_knownRows = 0; ///< of the history
    std::optional<What> m_open; ///< a change of this kind still belongs to the last step
    core::RowId m_openAt = 0; ///< the row at which that step was made
    /// The labels that were hidden before showAlone(); none: it was not called since.
    std::optional<std::vector<int>> m_hiddenBeforeAlone;
    bool m_held = false;
    bool m_own = false; ///< this object itself is changing what is shown
    QTimer m_rest;
};

/// Whether this segment is the only one that is shown.
[[nodiscard]] bool isShownAlone(const core::Document& document, int label);

} // namespace ui
