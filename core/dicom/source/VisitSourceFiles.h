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

/// Receives a file's header; @p slices are the indices of the slices in the file.
using TakeSourceFile = std::function<Result<void>(
    const QString& file, DcmDataset& header, const std::vector<std::size_t>& slices)>;

/// Reads the headers of the slices' files without pixel data, each file once, in no particular
/// order. If @p kept is given, it replaces the files, which are then not read. Slices of one file
/// need not be consecutive. Stops at the first error. Errors: FileNotFound, FileUnreadable,
/// Cancelled, and those of @p take.
[[nodiscard]] Result<void> visitSourceFiles(const std::vector<SourceSlice>& slices,
    const KeptHeaders* kept, const Progress& progress, const TakeSourceFile& take);

} // namespace core
