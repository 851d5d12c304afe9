// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <QWidget>

#include <optional>

class QDialog;
class QLabel;

namespace core {
struct Segment;
}

namespace ui {

class EditTrial;
class PreviewBox;
class Workspace;

/// The row of a dialog about one segment that previews what it would do: how many millilitres the
/// segment has, and would have, with the box that switches the preview on and off. The preview is
/// that of an edit that is worked out first.
class PreviewRow : public QWidget {
    Q_OBJECT

public:
    /// @param name of the dialog: "reshape" gives "reshapePreview" for the box and "reshapeNow" for
    /// the text
    PreviewRow(Workspace& workspace, const QString& name, QDialog* dialog);

    /// Previews an edit, if the box is checked; none: nothing can be done, or nothing is known yet.
    void preview(const std::optional<core::Edit>& edit);
    /// As EditTrial::handOver().
    [[nodiscard]] bool handOver(const core::Edit& edit);
    /// @param segment null: there is none
    void showState(const core::Segment* segment);

Q_SIGNALS:
    void switched(); ///< the box was
    void changed(); ///< a preview was begun or has ended, or more is known of it

private:
    Workspace& m_workspace;
    EditTrial* m_trial;
    QLabel* m_now;
    PreviewBox* m_box;
};

} // namespace ui
