// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/ViewSteps.h"

#include <QString>

namespace ui {

/// "Hide 'Skull'", "Show 3 segments", "Clip": the name of a change of the view in undo, redo and
/// the list of the history.
/// @param document provides the names of segments; a segment that it lacks is not named. Null: no
/// study is open
[[nodiscard]] QString viewStepText(const ViewSteps::Step& step, const core::Document* document);

} // namespace ui
