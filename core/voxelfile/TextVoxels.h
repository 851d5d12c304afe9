// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/voxelfile/StoredScalars.h"

#include <QFile>

#include <tl/expected.hpp>

#include <span>

namespace core {

/// Numbers in words, apart by blanks or commas, from the file's place on, as the type is stored in
/// this machine. Whether more follow; else why not: an empty reason where they end too soon.
[[nodiscard]] tl::expected<bool, QString> readTextVoxels(
    QFile& file, ScalarType type, std::span<char> into, const Progress& progress);

/// Two digits a byte, blanks between them or not. The same answer.
[[nodiscard]] tl::expected<bool, QString> readHexBytes(
    QFile& file, std::span<char> into, const Progress& progress);

} // namespace core
