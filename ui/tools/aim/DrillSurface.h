// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

namespace ui {

/// The threshold at which a drill starts: tissue from this modality value on counts as the surface.
/// It is what the user sees, as well as a single threshold can describe it.
///
/// Surface mode: its threshold. DVR: the lowest value of which `opaqueMm` hide half of what lies
/// behind (for a function that stays more transparent, the value with half of its greatest
/// opacity). MIP, which shows no surface: the threshold of the surface mode.
[[nodiscard]] double drillThreshold(
    const Workspace::VolumeDisplay& display, const core::Volume& volume);

inline constexpr double opaqueMm = 3.0;

/// "from 226 HU on", for the option bar and the cursor. Requires an open volume.
[[nodiscard]] QString startText(const Workspace& workspace);

} // namespace ui
