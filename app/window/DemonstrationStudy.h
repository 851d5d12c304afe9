// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/encoding/EarlySlice.h"

#include <QString>

namespace app {

/// The folder of the demonstration study between runs, in the user's cache.
[[nodiscard]] QString demonstrationFolder();

/// Writes the study there unless it exists, and loads it. Blocking; takes a few seconds the first
/// time.
[[nodiscard]] core::Result<core::LoadedVolume> loadDemonstration(
    const core::Progress& progress, const core::EarlySliceListener& early = {});

} // namespace app
