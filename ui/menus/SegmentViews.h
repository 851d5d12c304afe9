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

/// Adds to the window's actions how segments are looked at: the one before or after the active one
/// becomes active, the views go to it, it is shown alone, and what is drawn of segments in slices,
/// and whether their bodies are smooth. The last two are settings, which are restored now.
void addSegmentViews(Actions& actions, Workspace& workspace);

/// What an entry of a menu says that shows a segment alone (ViewSteps), as things stand.
[[nodiscard]] QString showAloneText(const Workspace& workspace, const core::Segment& segment);

/// Makes the segment of the voxel at a place the active one, when the session has answered whose
/// that is; tells the user which it is, or that there is none.
void activateSegmentAt(Workspace& workspace, const glm::dvec3& placeLps);

} // namespace ui
