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

/// What is done to a segment as a whole, and not to one that is locked: in the menu of its row, and
/// to the active one in the menu Segments.
struct SegmentAction {
    const char* id; ///< of the window's action: "segments.remove"
    QString text; ///< "Delete segment"; with the segment's name behind it where that is said,
    QString named{}; ///< unless this says it: "Fill holes of '%1'"
    QKeySequence keys{}; ///< heard in the list of segments alone
    void (*run)(Workspace& workspace, int label);
    bool makesFirst = false; ///< where there is no segment yet, one is added for it
    QString submenu{}; ///< the title of the one in which it stands, beside its like; empty: none
    /// Why it cannot be done to any segment now, empty if it can; null: it always can.
    QString (*whyNot)(const Workspace& workspace) = nullptr;
};
/// The text with the segment's name, where no list shows whose it is; null: without.
[[nodiscard]] QString namedText(const SegmentAction& action, const core::Segment* segment);
/// As menus have them.
[[nodiscard]] const std::vector<SegmentAction>& segmentActions();

} // namespace ui
