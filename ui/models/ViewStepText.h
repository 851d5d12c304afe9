// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/ViewSteps.h"

#include <QString>

namespace ui {

/// "Hide 'Skull'", "Show 3 segments", "Clip": what a change of what is shown is called by undo,
/// redo and the list of the history.
/// @param document whose names the segments have; one that it does not hold is not named. Null: no
/// study is open
[[nodiscard]] QString viewStepText(const ViewSteps::Step& step, const core::Document* document);

} // namespace ui
