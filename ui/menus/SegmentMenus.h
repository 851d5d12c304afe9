// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <functional>

class QAction;
class QMenu;

namespace core {
struct Document;
struct Segment;
} // namespace core

namespace ui {

class Workspace;
struct SegmentAction;

// Parts of menus about segments, in most of which another one is chosen for what is done to one. An
// entry that cannot be chosen says why by its tool tip.

/// Why no voxel of a segment can be changed; empty if they can.
/// @param segment null: there is none
[[nodiscard]] QString whyUnchangeable(const core::Segment* segment);

/// Fills a menu with all segments but one, in the order of their list.
/// @param choose is called with the label of the chosen one
/// @param changes whether something is done to that one, which must not be locked then
/// @return why none of them can be chosen; empty if one can
QString listOtherSegments(QMenu& menu, const core::Document& document, int but,
    const std::function<void(int)>& choose, bool changes = true);

/// The menu in which an entry for an action stands that is added to this one: itself, or its
/// submenu of the action's title, which is made where it ends if there is none yet.
[[nodiscard]] QMenu& menuOf(QMenu& menu, const SegmentAction& action);

/// Adds "Merge into", "Swap with" and "Measure distance to" to a menu. They are listed anew
/// whenever the menu opens.
/// @param before the action that they stand before; null: at the end
/// @param label of the segment that the menu is about then
/// @param named whether they say that segment's name, since no list shows whose they are
void addCombinations(QMenu& menu, QAction* before, Workspace& workspace,
    const std::function<int()>& label, bool named);

} // namespace ui
