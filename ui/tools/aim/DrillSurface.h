// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

namespace ui {

/// The modality value from which on tissue counts as the surface that a drill starts at: what is
/// seen, as near as one threshold can say it.
///
/// Surface: its threshold. DVR: the lowest value of which `opaqueMm` hide half of what lies behind
/// (of a function that stays clearer, the half of its greatest opacity). MIP shows no surface: the
/// threshold of the surface mode.
[[nodiscard]] double drillThreshold(
    const Workspace::VolumeDisplay& display, const core::Volume& volume);

inline constexpr double opaqueMm = 3.0;

/// "from 226 HU on", for the option bar and the cursor. Expects an open volume.
[[nodiscard]] QString startText(const Workspace& workspace);

} // namespace ui
