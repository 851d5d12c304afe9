// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QString>

#include <vector>

namespace core {
struct Segment;
}

namespace ui {

class Workspace;

/// An action on one whole segment: an entry of the menu of the segment's row in the list and, for
/// the active segment, of the menu Segments.
struct SegmentAction {
    const char* id; ///< of the window's action: "segments.remove"
    QString text; ///< "Delete segment"
    /// With a place for the segment's name: "Fill holes of '%1'"; empty: namedText() appends it.
    QString named{};
    QKeySequence keys{}; ///< shortcut that works only in the list of segments
    void (*run)(Workspace& workspace, int label);
    bool makesFirst = false; ///< also works without any segment, by adding one first
    bool onlyReads = false; ///< it leaves the segment as it is, so it also works for a locked one
    QString submenu{}; ///< title of the submenu that holds this entry; empty: none
    /// Returns why the action is not possible now for any segment; empty: it is possible. Null:
    /// always possible.
    QString (*whyNot)(const Workspace& workspace) = nullptr;
};
/// Text of the entry with the segment's name, for menus outside the list of segments, where no row
/// shows which segment is meant. @p segment null: without a name.
[[nodiscard]] QString namedText(const SegmentAction& action, const core::Segment* segment);
/// All actions, in the order of the menus. They live as long as the program.
[[nodiscard]] const std::vector<SegmentAction>& segmentActions();

} // namespace ui
