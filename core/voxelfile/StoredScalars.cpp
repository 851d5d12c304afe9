// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/StoredScalars.h"

#include "core/volume/encoding/VolumeEncoder.h"

#include <QtEndian>

#include <cstring>

namespace core {

namespace {

template <class Stored> double storedAt(const char* bytes, std::size_t index)
{
    Stored value;
    std::memcpy(&value, bytes + index * sizeof(Stored), sizeof(Stored));
    return double(value);
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
    if (bytesPerScalar(type) <= 2) {
        const std::size_t voxels = geometry.voxelCount();
        loaded.codes.resize(voxels);
        for (std::size_t voxel = 0; voxel < voxels; ++voxel)
            loaded.codes[voxel] = std::uint16_t(int(stored(data, voxel)));
        const bool isSigned = type == ScalarType::Int8 || type == ScalarType::Int16;
        const std::vector<SliceRescale> slices(std::size_t(geometry.size.z),
            SliceRescale{.slope = slope, .intercept = intercept, .isSigned = isSigned});
        encodeStoredValues(loaded, slices, hasWindow);
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

} // namespace core
