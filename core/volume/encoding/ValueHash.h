// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Sha256.h"
#include "core/volume/VoxelEncoding.h"

#include <cstdint>
#include <span>
#include <vector>

namespace core {

// The data of Volume::voxelsSha256: modality values as float32, little-endian.

void addFloats(Sha256& hash, std::span<const float> values);

/// The float32 value of each code.
[[nodiscard]] std::vector<float> valuesOfCodes(const VoxelEncoding& encoding);

/// Adds the values that a table gives for codes or stored bits.
void addByTable(
    Sha256& hash, std::span<const std::uint16_t> codes, const std::vector<float>& table);

/// The same for values that are stored numbers plus an integer; several times as fast.
void addShifted(Sha256& hash, std::span<const std::uint16_t> bits, bool isSigned, int shift);

} // namespace core
