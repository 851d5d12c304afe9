// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
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

/// Whether numbers of this type can be read to where their codes will be, so that no volume is in
/// memory twice: those of up to 16 bits.
[[nodiscard]] bool fitsCodes(ScalarType type);
/// Checks, as checkMemory(), that so many numbers can be read and encoded: their codes fit, and
/// beside them the numbers themselves unless they fit codes.
[[nodiscard]] Result<void> checkScalarMemory(std::size_t voxels, ScalarType type);
/// Where to read them to: memory of @p loaded.codes, which it allocates, for as many numbers as the
/// volume has voxels. The volume's geometry must be set. @pre fitsCodes(type)
[[nodiscard]] std::span<char> roomForScalars(LoadedVolume& loaded, ScalarType type);
/// The same as encodeScalars() for the numbers that are in that room.
void encodeScalarsInRoom(
    LoadedVolume& loaded, ScalarType type, double slope, double intercept, bool hasWindow);

} // namespace core
