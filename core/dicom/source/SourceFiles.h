// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <cstddef>
#include <functional>
#include <vector>

class DcmDataset;

namespace core {

/// Takes a file's header; @p slices are the indices of the slices that the file holds.
using TakeSourceFile = std::function<Result<void>(
    const QString& file, DcmDataset& header, const std::vector<std::size_t>& slices)>;

/// Reads the headers of the slices' files anew, pixel data not touched; each file once, in no
/// order. Where @p kept is there it stands for the files, which are not looked at. Slices of one
/// file need not follow each other. Ends at the first error. Errors: FileNotFound, FileUnreadable,
/// Cancelled, and those of @p take.
[[nodiscard]] Result<void> visitSourceFiles(const std::vector<SourceSlice>& slices,
    const KeptHeaders* kept, const Progress& progress, const TakeSourceFile& take);

} // namespace core
