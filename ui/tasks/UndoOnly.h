// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/Touch.h"

#include <QString>

namespace ui {

class Workspace;

/// "Undo only here": takes back the last step that touched something and leaves all others, as a
/// new step. Says what came of it; refusals name the step that stands in the way.
/// @param place what was meant, to go on "There is no step to undo … ": "in 'Skull'"
void undoOnlyLast(Workspace& workspace, const core::Touch& touch, const QString& place);

} // namespace ui
