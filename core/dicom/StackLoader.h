// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/DicomScan.h"

namespace core {

/// Decodes a stack, or of one in time the point @p time (0: the first). Slices that fail are left
/// out and named in the problems; FileTruncated or the first failure if none is left, OutOfMemory,
/// Cancelled.
[[nodiscard]] Result<LoadedVolume> loadStack(
    const ListedStack& listed, int time, const Progress& progress);

} // namespace core
