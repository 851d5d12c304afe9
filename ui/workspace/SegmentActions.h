// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QKeySequence>
#include <QString>

#include <cstdint>
#include <vector>

namespace core {
struct Document;
}

namespace ui {

class Workspace;

/// The next of twelve colours that keep apart on grey, told by how many segments there are.
[[nodiscard]] std::uint32_t nextSegmentColour(const core::Document& document);
/// "Segment 3": the first such name that is free.
[[nodiscard]] QString nextSegmentName(const core::Document& document);

/// Adds a segment as an entry of its own and makes it the active one. @return its label
core::Result<int> addSegment(Workspace& workspace);
/// The active segment; if there is none, the first one, and if there is no segment, a new one.
core::Result<int> ensureActiveSegment(Workspace& workspace);

/// Deletes a segment with its voxels, as an entry of its own, and says so; the one below it, or
/// else above, becomes the active one. What cannot be done is told by the workspace.
void removeSegment(Workspace& workspace, int label);

/// What is done to a segment as a whole, and not to one that is locked: in the menu of its row, and
/// to the active one in the menu Segments.
struct SegmentAction {
    const char* id; ///< of the window's action: "segments.remove"
    QString text; ///< "Delete segment"; with the segment's name behind it where that is said
    QKeySequence keys{}; ///< heard in the list of segments alone
    void (*run)(Workspace& workspace, int label);
};
/// As menus have them.
[[nodiscard]] const std::vector<SegmentAction>& segmentActions();

} // namespace ui
