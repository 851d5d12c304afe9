// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/history/History.h"
#include "ui/dialogs/segment/SegmentDialog.h"
#include "ui/tasks/LabelFetch.h"

#include <QTimer>

#include <optional>
#include <utility>

namespace ui {

/// A dialog that looks through the labels of its segment: the engine reads them while the window
/// goes on, and another thread looks through them, anew after each step of the history. They are as
/// large as the volume: nobody keeps them who does not look at them.
class LabelLookDialog : public SegmentDialog {
    Q_OBJECT

public:
    LabelLookDialog(
        Workspace& workspace, const QString& title, const QString& name, QWidget* parent);

protected:
    void hideEvent(QHideEvent* event) override;

    /// Looks anew.
    void look();
    /// Whether something of the present state is still to come.
    [[nodiscard]] bool isLooking() const { return m_isLooking; }
    /// Has the labels of the segment's plane looked through, by lookThrough().
    virtual void count(const LabelFetch::Planes& planes) = 0;
    /// Drops what was read and found.
    virtual void forgetFound() = 0;
    /// Has another thread look through what count() was given, and shows the state after @p take
    /// was given what it found.
    template <class Look, class Take> void lookThrough(Look look, Take take)
    {
        m_isLooking = true;
        m_counting.replace(
            this, std::move(look), [this, take = std::move(take)](const auto& found) {
                m_isLooking = false;
                if (found)
                    take(*found);
                showState();
            });
    }

private:
    void forget();
    void follow(const core::DocumentChange& change);

    bool m_isLooking = false;
    std::optional<core::RowId> m_position; ///< of the history, at which it was looked
    QTimer m_lookSoon; ///< after several changes once
    LabelFetch m_fetch;
    core::Background m_counting; ///< last: its results are delivered to all of the above
};

} // namespace ui
