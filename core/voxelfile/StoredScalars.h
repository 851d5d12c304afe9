// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstddef>
#include <span>

namespace core {

/// What one voxel of a file is. One number; colours and vectors are none.
enum class ScalarType {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
};

[[nodiscard]] std::size_t bytesPerScalar(ScalarType type);
[[nodiscard]] bool isFloating(ScalarType type);

/// The number at a place, stored in the machine's byte order.
using StoredAt = double (*)(const char* bytes, std::size_t index);
[[nodiscard]] StoredAt storedAtFor(ScalarType type);

/// Between a foreign byte order and the machine's, in place.
void swapScalars(std::span<char> bytes, ScalarType type);

/// Stored numbers, in the machine's byte order, x fastest, as what was read becomes a volume:
/// value = slope · stored + intercept. Whole numbers of up to 16 bits keep their own code, all else
/// is brought to a scale (encodeValues). The volume's geometry must be set.
/// @param bytes as many as the volume has voxels
void encodeScalars(LoadedVolume& loaded, std::span<const char> bytes, ScalarType type, double slope,
    double intercept, bool hasWindow);

} // namespace core
