// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

// Some strokes begin only when a question about voxels is answered: what is seen under the pen, on
// which side of a border it is. While the session works on something else, the pen may have been
// lifted long before. What was drawn until the pen was lifted is a stroke nevertheless.

/// Says that no stroke is begun while the one before waits for its answer.
void sayStrokeWaits(Workspace& workspace);
/// Says that a stroke was dropped because another one has been begun before its answer came.
void sayStrokeCameTooLate(Workspace& workspace);
/// What undo drops then (Tool::stepText()).
[[nodiscard]] QString waitingStrokeText();
/// Whether an edit stands open that a stroke must not end. A growth may be ended, and so may a
/// preview.
[[nodiscard]] bool isStrokeOpen(const core::EditSession& session);

} // namespace ui
