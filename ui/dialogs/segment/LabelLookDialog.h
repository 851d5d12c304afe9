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

/// Base of dialogs that show something computed from all labels of their segment's plane. The
/// engine reads the labels while the window goes on, a background thread computes, and both are
/// repeated after each step of the history. The labels take one byte per voxel of the volume, so
/// they are dropped when the dialog is hidden.
class LabelLookDialog : public SegmentDialog {
    Q_OBJECT

public:
    LabelLookDialog(
        Workspace& workspace, const QString& title, const QString& name, QWidget* parent);

protected:
    void hideEvent(QHideEvent* event) override;

    /// Drops what is known, then reads and computes again. While an edit is open nothing is read;
    /// the step with which it ends starts the next look, and while there is another dialog's
    /// preview it is tried again.
    void look();
    /// Whether labels are being read or computed on.
    [[nodiscard]] bool isLooking() const { return m_isLooking; }
    /// Called with the labels once they are read. Implementations start their computation with
    /// lookThrough().
    virtual void count(const LabelFetch::Planes& planes) = 0;
    /// Called when the labels and what was found from them are to be dropped.
    virtual void forgetFound() = 0;
    /// Runs @p look on a background thread. When it has succeeded, calls @p take with its result;
    /// in any case calls showState() afterwards. A computation that still runs is replaced.
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
    std::optional<core::RowId> m_position; ///< position of the history of the last look
    QTimer m_lookSoon; ///< joins several changes into one look
    LabelFetch m_fetch;
    core::Background m_counting; ///< last: its results are delivered to all of the above
};

} // namespace ui
