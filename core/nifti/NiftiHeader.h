// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <QByteArray>

#include <array>

namespace core {

/// The 348 bytes of a NIfTI-1 header and the 4 of "no extension", little endian.
struct NiftiHeader {
    static constexpr int voxelOffset = 352;
    enum class DataType : std::int16_t { UInt8 = 2, Int16 = 4, Float32 = 16 };

    std::array<char, voxelOffset> bytes{};
    bool qform = false; ///< the quaternion agrees with the affine
};

/// @param labels for bytes: whether the intent states that they are labels
[[nodiscard]] NiftiHeader makeNiftiHeader(const VolumeGeometry& geometry,
    NiftiHeader::DataType type, const QByteArray& description, bool labels = true);

} // namespace core
