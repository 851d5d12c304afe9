// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/words/Clause.h"
#include "core/voxelfile/StoredScalars.h"

#include <QFile>

#include <tl/expected.hpp>

#include <span>

namespace core {

/// Reads numbers as text, separated by blanks or commas, from the file's position on, and stores
/// them in the type's form on this machine. Returns whether more follow, or why it failed; the
/// reason is empty if they end too soon.
[[nodiscard]] tl::expected<bool, Clause> readTextVoxels(
    QFile& file, ScalarType type, std::span<char> into, const Progress& progress);

/// Reads bytes of two hexadecimal digits, with or without blanks between them. Result as above.
[[nodiscard]] tl::expected<bool, Clause> readHexBytes(
    QFile& file, std::span<char> into, const Progress& progress);

} // namespace core
