// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/words/Clause.h"

#include <QString>

#include <cstddef>

namespace core {

/// Checks that a volume of that many voxels, with 2 bytes each, fits into 60 % of the machine's
/// memory. The error OutOfMemory says how much is needed and how much there is.
[[nodiscard]] Result<void> checkMemory(std::size_t voxels);
/// The same for what takes so many bytes.
/// @param what takes them, as a clause begins with it: "the volume"
[[nodiscard]] Result<void> checkBytes(double bytes, const Clause& what);
/// The most that it allows.
[[nodiscard]] double allowedBytes();

} // namespace core
