// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/Touch.h"

#include <QString>

namespace ui {

class Workspace;

/// "Undo only here": takes back the last step that touched something and keeps all later ones, as a
/// new step. It tells the user what happened; a refusal names the step that stands in the way.
/// @param place completes the sentence "There is no step to undo …": "in 'Skull'"
void undoOnlyLast(Workspace& workspace, const core::Touch& touch, const QString& place);

} // namespace ui
