// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QString>

#include <optional>
#include <vector>

namespace ui {

/// The range of values that the 3D view shows, for "segment what I see".
struct ShownValues {
    std::optional<double> lower; ///< modality units, inclusive; none: any
    std::optional<double> upper;
    QString why; ///< why there is no such range, for the user; empty if there is
};

/// Surface: from the threshold on. Volume rendering: where the transfer function reaches half of
/// its greatest opacity, if that is a single interval. The other modes have no such range.
[[nodiscard]] ShownValues shownValues(const Workspace::VolumeDisplay& display);

} // namespace ui
