// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/stack/DicomScan.h"
#include "core/volume/encoding/EarlySlice.h"

namespace core {

/// Decodes a stack, or of one in time the point @p time (0: the first). Slices that fail are left
/// out and named in the problems; FileTruncated or the first failure if none is left, OutOfMemory,
/// Cancelled.
/// @param early hears of the slice in the middle as soon as it is decoded, which is before the
/// others, where it looks then as it will afterwards: not where the window follows from all voxels
/// because the file of the middle slice has none, and not of floating-point numbers
[[nodiscard]] Result<LoadedVolume> loadStack(const ListedStack& listed, int time,
    const Progress& progress, const EarlySliceListener& early = {});

} // namespace core
