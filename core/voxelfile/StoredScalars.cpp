// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/StoredScalars.h"

#include "core/base/LargePages.h"
#include "core/volume/MemoryLimit.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <QtEndian>

#include <algorithm>
#include <cstring>

namespace core {

namespace {

template <class Stored> double storedAt(const char* bytes, std::size_t index)
{
    Stored value;
    std::memcpy(&value, bytes + index * sizeof(Stored), sizeof(Stored));
    return double(value);
}

/// The numbers in the room that roomForScalars() gave.
std::span<char> room(LoadedVolume& loaded, ScalarType type)
{
    const std::size_t bytes = loaded.codes.size() * bytesPerScalar(type);
    const std::size_t all = loaded.codes.size() * sizeof(std::uint16_t);
    return {reinterpret_cast<char*>(loaded.codes.data()) + (all - bytes), bytes};
}

/// Makes codes of the single bytes behind them: each code ends before the bytes that are still to
/// be read, or with the one that it is made of.
template <class Byte> void spread(std::span<const char> bytes, std::uint16_t* codes)
{
    for (std::size_t voxel = 0; voxel < bytes.size(); ++voxel)
        codes[voxel] = std::uint16_t(int(Byte(bytes[voxel])));
}

} // namespace

StoredAt storedAtFor(ScalarType type)
{
    switch (type) {
    case ScalarType::Int8:
        return storedAt<std::int8_t>;
    case ScalarType::UInt8:
        return storedAt<std::uint8_t>;
    case ScalarType::Int16:
        return storedAt<std::int16_t>;
    case ScalarType::UInt16:
        return storedAt<std::uint16_t>;
    case ScalarType::Int32:
        return storedAt<std::int32_t>;
    case ScalarType::UInt32:
        return storedAt<std::uint32_t>;
    case ScalarType::Int64:
        return storedAt<std::int64_t>;
    case ScalarType::UInt64:
        return storedAt<std::uint64_t>;
    case ScalarType::Float32:
        return storedAt<float>;
    case ScalarType::Float64:
        break;
    }
    return storedAt<double>;
}

std::size_t bytesPerScalar(ScalarType type)
{
    switch (type) {
    case ScalarType::Int8:
    case ScalarType::UInt8:
        return 1;
    case ScalarType::Int16:
    case ScalarType::UInt16:
        return 2;
    case ScalarType::Int32:
    case ScalarType::UInt32:
    case ScalarType::Float32:
        return 4;
    case ScalarType::Int64:
    case ScalarType::UInt64:
    case ScalarType::Float64:
        break;
    }
    return 8;
}

bool isFloating(ScalarType type)
{
    return type == ScalarType::Float32 || type == ScalarType::Float64;
}

void swapScalars(std::span<char> bytes, ScalarType type)
{
    const std::size_t each = bytesPerScalar(type);
    const auto count = qsizetype(bytes.size() / each);
    if (each == 2)
        qbswap<2>(bytes.data(), count, bytes.data());
    else if (each == 4)
        qbswap<4>(bytes.data(), count, bytes.data());
    else if (each == 8)
        qbswap<8>(bytes.data(), count, bytes.data());
}

void encodeScalars(LoadedVolume& loaded, std::span<const char> bytes, ScalarType type, double slope,
    double intercept, bool hasWindow)
{
    const VolumeGeometry& geometry = loaded.volume.geometry;
    const StoredAt stored = storedAtFor(type);
    const char* data = bytes.data();
    if (fitsCodes(type)) {
        const std::span<char> to = roomForScalars(loaded, type);
        std::copy_n(data, to.size(), to.data());
        encodeScalarsInRoom(loaded, type, slope, intercept, hasWindow);
        return;
    }
    const std::size_t size = std::size_t(geometry.size.x) * std::size_t(geometry.size.y);
    encodeValues(
        loaded,
        [&](int k, std::span<double> values) {
            for (std::size_t voxel = 0; voxel < size; ++voxel)
                values[voxel] = slope * stored(data, std::size_t(k) * size + voxel) + intercept;
        },
        hasWindow);
}

bool fitsCodes(ScalarType type)
{
    return bytesPerScalar(type) <= sizeof(std::uint16_t);
}

Result<void> checkScalarMemory(std::size_t voxels, ScalarType type)
{
    return checkMemory(fitsCodes(type) ? voxels : voxels + voxels * bytesPerScalar(type) / 2);
}

std::span<char> roomForScalars(LoadedVolume& loaded, ScalarType type)
{
    loaded.codes.clear();
    resizeInLargePages(loaded.codes, loaded.volume.geometry.voxelCount());
    return room(loaded, type);
}

void encodeScalarsInRoom(
    LoadedVolume& loaded, ScalarType type, double slope, double intercept, bool hasWindow)
{
    // Numbers of 16 bits are where they should be, as the bits that they are.
    if (type == ScalarType::UInt8)
        spread<std::uint8_t>(room(loaded, type), loaded.codes.data());
    else if (type == ScalarType::Int8)
        spread<std::int8_t>(room(loaded, type), loaded.codes.data());
    const bool isSigned = type == ScalarType::Int8 || type == ScalarType::Int16;
    const std::vector<SliceRescale> slices(std::size_t(loaded.volume.geometry.size.z),
        SliceRescale{.slope = slope, .intercept = intercept, .isSigned = isSigned});
    encodeStoredValues(loaded, slices, hasWindow);
}

} // namespace core
