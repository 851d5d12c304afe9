// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/stack/DicomScan.h"
#include "core/volume/encoding/EarlySlice.h"

namespace core {

/// Decodes a stack, or the point @p time of a stack in time (0: the first). Slices that fail are
/// left out and listed in the problems. Errors: FileTruncated or the first failure if no slice is
/// left, OutOfMemory, Cancelled.
/// @param early receives the middle slice as soon as it is decoded, before all others, if it can be
/// displayed then as it will be afterwards. This is impossible for floating-point numbers and
/// pixels of 32 bits, and if the window depends on all voxels because the middle slice's file has
/// none.
[[nodiscard]] Result<LoadedVolume> loadStack(const ListedStack& listed, int time,
    const Progress& progress, const EarlySliceListener& early = {});

} // namespace core
