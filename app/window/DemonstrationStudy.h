// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/encoding/EarlySlice.h"

#include <QString>

namespace app {

/// Where the demonstration study lies between runs: the user's cache folder.
[[nodiscard]] QString demonstrationFolder();

/// Writes it there unless it is there already, and loads it. Blocking; a few seconds the first
/// time.
[[nodiscard]] core::Result<core::LoadedVolume> loadDemonstration(
    const core::Progress& progress, const core::EarlySliceListener& early = {});

} // namespace app
