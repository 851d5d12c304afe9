// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <vector>

namespace core {

/// What stands for the files of slices where these may be missing: of every file patient, study,
/// series, instance and where its frames lie; enough for writeSeg() and readSourceHeaders(), and
/// nothing else of the header. About 1 KB each. Errors: those of visitSourceFiles().
[[nodiscard]] Result<KeptHeaders> keepHeaders(
    const std::vector<SourceSlice>& slices, const Progress& progress);

} // namespace core
