// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <vector>

namespace core {

/// Replacements for the files of slices, for when the files are missing: patient, study, series,
/// instance and the positions of frames of every file. This is enough for writeSeg() and
/// readSourceHeaders(), and nothing else of the headers is kept. About 1 KB each. Errors: those of
/// visitSourceFiles().
[[nodiscard]] Result<KeptHeaders> keepHeaders(
    const std::vector<SourceSlice>& slices, const Progress& progress);

} // namespace core
