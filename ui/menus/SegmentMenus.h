// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <functional>

class QAction;
class QMenu;

namespace core {
struct CombineSegments;
struct Document;
struct Segment;
} // namespace core

namespace ui {

class Workspace;
struct SegmentAction;

// Parts of menus about segments. In most of them the user chooses a second segment. The tool tip of
// a disabled entry says why it is disabled.

/// Returns why the voxels of a segment cannot be changed; empty if they can.
/// @param segment null: there is no segment
[[nodiscard]] QString whyUnchangeable(const core::Segment* segment);

/// Which other segments an action can be carried out with.
enum class OtherSegment {
    Changed, ///< it changes the other one, too: not locked, and in the same label plane
    Unlocked, ///< the same, in any label plane
    Overlapping, ///< it compares the voxels of both: in another label plane
    Any,
};

/// Fills a menu with all segments except one, in the order of the list of segments. Entries of
/// segments that are not of the kind are disabled.
/// @param but the label of the segment that is left out
/// @param choose is called with the label of the chosen segment
/// @param pointedAt is called with the label of a segment whose entry is pointed at, or has the
/// keyboard; 0: it is disabled
/// @return why no segment can be chosen; empty if at least one can
QString listOtherSegments(QMenu& menu, const core::Document& document, int but,
    const std::function<void(int)>& choose, OtherSegment kind = OtherSegment::Changed,
    const std::function<void(int)>& pointedAt = {});

/// Returns the menu to which the entry of an action is to be added: @p menu itself, or its submenu
/// with the action's submenu title. A missing submenu is appended.
[[nodiscard]] QMenu& menuOf(QMenu& menu, const SegmentAction& action);

/// Adds the submenu "Add segment that may overlap" to a menu: all others, in a label plane of its
/// own, or, where there are several planes, all but the segments of one, beside which it is added.
/// It is filled anew whenever the menu opens.
/// @param before the action before which it is inserted; null: at the end
void addOverlaps(QMenu& menu, QAction* before, Workspace& workspace);

/// What becomes of the entries of "Combine". Their edits keep to the editable range.
struct CombineChoice {
    std::function<void(const core::CombineSegments&)> choose;
    /// An entry is pointed at, or has the keyboard; null: what is pointed at can do nothing.
    std::function<void(const core::CombineSegments*)> pointedAt{};
};

/// Adds what addCombinations() has in its submenu "Combine" to a menu that has nothing else.
void addCombineEntries(QMenu& menu, Workspace& workspace, const std::function<int()>& label,
    const CombineChoice& choice);

/// Adds the submenus "Combine" and "Measure distance to" to a menu. "Combine" has "Merge into" and
/// "Swap with", and also "Add voxels of", "Subtract" and "Intersect with" while there are several
/// label planes. They are filled anew whenever the menu opens. Above them stands the editable range
/// while it is on (addEditableNote()).
/// @param before the action before which they are inserted; null: at the end
/// @param label returns the label of the segment that the menu is about at that moment
/// @param named whether their titles contain that segment's name, for menus outside the list of
/// segments
void addCombinations(QMenu& menu, QAction* before, Workspace& workspace,
    const std::function<int()>& label, bool named);

} // namespace ui
