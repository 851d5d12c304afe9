// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <QString>
#include <QWidget>

#include <optional>

class QLabel;

namespace core {
struct Segment;
}

namespace ui {

class EditTrial;
class PreviewBox;
class Workspace;

/// The row of a dialog or panel about one segment that previews what it would do: how many
/// millilitres the segment has, and would have, with the box that switches the preview on and off.
/// The edits that it previews are computed before they are shown.
class PreviewRow : public QWidget {
    Q_OBJECT

public:
    enum class In {
        Dialog,
        /// As wide as the column of panels; it counts the voxels, too. Its preview gives way to
        /// those of dialogs.
        Column,
    };
    /// @param name of the owner: "reshape" gives "reshapePreview" for the box and "reshapeNow" for
    /// the text
    /// @param owner the dialog, which ends the preview when it closes, or the panel
    PreviewRow(Workspace& workspace, const QString& name, QWidget* owner, In place = In::Dialog);

    /// Previews an edit, if the box is checked; none: nothing can be done, or nothing is known yet.
    void preview(const std::optional<core::Edit>& edit);
    /// Whether a preview is seen, or on its way.
    [[nodiscard]] bool isPreviewing() const;
    /// As EditTrial::handOver().
    [[nodiscard]] bool handOver(const core::Edit& edit);
    /// @param segment null: there is none
    void showState(const core::Segment* segment);

Q_SIGNALS:
    void switched(); ///< the box was
    void changed(); ///< a preview was begun or has ended, or more is known of it

private:
    [[nodiscard]] QString stateText(const core::Segment& segment) const;
    [[nodiscard]] QString shortText(const core::Segment& segment) const;

    Workspace& m_workspace;
    In m_place;
    EditTrial* m_trial;
    QLabel* m_now;
    PreviewBox* m_box;
};

} // namespace ui
