// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/edits/kinds/Edit.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <memory>
#include <optional>

class QWidget;

namespace core {
class LabelReader;
}

namespace ui {

class Workspace;

/// Previews an edit of a segment in all views before it becomes a step of the history. The preview
/// is an open edit of the session; for another edit it is rolled back and begun again. Any other
/// edit takes the preview back, and so does a dialog that shows it when it closes; a panel drops it
/// when it is hidden. Once a preview has stayed for a moment, the segment's voxels in it are
/// counted in the background.
class EditTrial : public QObject {
    Q_OBJECT

public:
    /// When a preview is begun after it was requested.
    enum class Pace {
        /// A moment later. If requests arrive faster than that, only the latest one is shown.
        AtOnce,
        /// When nothing else was requested for a while: for edits that must be computed first,
        /// which takes time. A new request stops the computation for an earlier one.
        AtRest,
        /// As AtRest, for what the pointer only rests on. It does not replace the preview of a
        /// dialog but waits until that has ended; and it waits until label planes are no longer
        /// being read (by an export or an audit), because an open edit would make the reader begin
        /// again.
        InPassing,
    };
    /// @param owner the dialog or panel that shows it; becomes its parent
    EditTrial(Workspace& workspace, Pace pace, QWidget* owner);

    /// Requests the preview of @p edit, which can stand open (core/edits/EditTask.h). Nothing is
    /// shown for an edit that the session refuses.
    void show(const core::Edit& edit);
    /// Ends the preview; all voxels are as before.
    void drop();
    /// Ends the preview for @p edit to be carried out. If it is the one that is previewed, it is
    /// left standing open, even if it is still being computed: the caller commits it, so that
    /// nothing is computed again.
    /// @return whether it stands open
    [[nodiscard]] bool handOver(const core::Edit& edit);
    /// Whether a preview is there, or on its way. One that waits for a stroke or a growth to end is
    /// neither.
    [[nodiscard]] bool isShown() const;
    /// How many voxels the segment has in the preview that is shown; none until they are counted.
    [[nodiscard]] std::optional<std::int64_t> voxels() const;
    /// Whether a preview is on its way, or its voxels are being counted.
    [[nodiscard]] bool isCounting() const;

Q_SIGNALS:
    void changed(); ///< voxels() or isCounting()

private:
    void begin();
    [[nodiscard]] bool isOpen() const;
    [[nodiscard]] bool isOf(const core::Edit& edit) const;
    void rollBack();
    void count();
    void awaitBegin();
    void readOn();
    void stopCounting();

    Workspace& m_workspace;
    Pace m_pace;
    std::optional<core::Edit> m_wanted;
    /// The edit that was begun; it may have been ended by another one since.
    std::optional<core::Edit> m_shown;
    QTimer m_soon;
    QTimer m_countSoon; ///< delay after the preview has begun
    std::shared_ptr<core::LabelReader> m_reader; ///< null: nothing is being counted
    std::optional<std::int64_t> m_voxels; ///< of m_shown
    bool m_hasBegun = false; ///< the engine has begun m_shown; it may still be working on it
    core::Background m_counting; ///< last: it uses all of the above
};

} // namespace ui
