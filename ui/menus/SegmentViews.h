// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

namespace core {
struct Segment;
}

namespace ui {

class Actions;
class Workspace;

/// Adds the window's actions about viewing segments: make the previous or next segment active,
/// centre the views on the active one, show it alone, how segments are drawn in slices, and whether
/// their surfaces in 3D are smoothed. The last two are saved settings; this call restores them.
void addSegmentViews(Actions& actions, Workspace& workspace);

/// Text of the menu entry that shows a segment alone. If it is shown alone already, the entry shows
/// the others again, or all segments if it is not known which were shown before (ViewSteps).
[[nodiscard]] QString showAloneText(const Workspace& workspace, const core::Segment& segment);

/// Asks the session for the segments at a place (LPS mm) and makes one of them active; if several
/// overlap, repeated calls go through them (core::segmentNext()). The workspace tells the user
/// which one is active, or that there is none.
void activateSegmentAt(Workspace& workspace, const glm::dvec3& placeLps);

} // namespace ui
