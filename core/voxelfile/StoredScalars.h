// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstddef>
#include <span>

namespace core {

/// The type of one voxel in a file: a single number. Colours and vectors are not supported.
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

/// Reads the number at an index, stored in the machine's byte order.
using StoredAt = double (*)(const char* bytes, std::size_t index);
[[nodiscard]] StoredAt storedAtFor(ScalarType type);

/// Converts between a foreign byte order and the machine's, in place.
void swapScalars(std::span<char> bytes, ScalarType type);

/// Converts stored numbers, in the machine's byte order, x fastest, into the codes of a volume:
/// value = slope · stored + intercept. Integers of up to 16 bits are encoded exactly, everything
/// else is scaled (encodeValues). The volume's geometry must be set.
/// @param bytes of as many numbers as the volume has voxels
void encodeScalars(LoadedVolume& loaded, std::span<const char> bytes, ScalarType type, double slope,
    double intercept, bool hasWindow);

} // namespace core
