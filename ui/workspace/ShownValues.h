// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QString>

#include <optional>
#include <vector>

namespace ui {

/// Which values the 3D view shows, for "segment what I see".
struct ShownValues {
    std::optional<double> lower; ///< modality units, inclusive; none: any
    std::optional<double> upper;
    QString why; ///< why that cannot be said, for the user; empty if it can
};

/// Surface: from the threshold on. Volume rendering: where the transfer function reaches half of
/// its greatest opacity, if that is one interval. The others show no values before others.
[[nodiscard]] ShownValues shownValues(const Workspace::VolumeDisplay& display);

} // namespace ui
