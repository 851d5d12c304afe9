// SPDX-License-Identifier: Apache-2.0
#include "core/volume/encoding/ValueHash.h"

#include <algorithm>
#include <array>
#include <limits>

namespace core {

namespace {

template <class Convert>
void addConverted(Sha256& hash, std::span<const std::uint16_t> bits, Convert valueOf)
{
    // In pieces that stay in the innermost cache.
    std::array<float, 4096> values;
    while (!bits.empty()) {
        const std::span<const std::uint16_t> piece =
            bits.first(std::min(bits.size(), values.size()));
        std::transform(piece.begin(), piece.end(), values.begin(), valueOf);
        addFloats(hash, std::span(values).first(piece.size()));
        bits = bits.subspan(piece.size());
    }
}

} // namespace

void addFloats(Sha256& hash, std::span<const float> values)
{
    static_assert(std::numeric_limits<float>::is_iec559);
    hash.add(values.data(), values.size_bytes());
}

std::vector<float> valuesOfCodes(const VoxelEncoding& encoding)
{
    std::vector<float> values(VoxelEncoding::codeCount);
    for (int code = 0; code < VoxelEncoding::codeCount; ++code)
        values[std::size_t(code)] = float(encoding.value(code));
    return values;
}

void addByTable(Sha256& hash, std::span<const std::uint16_t> codes, const std::vector<float>& table)
{
    addConverted(hash, codes, [&table](std::uint16_t code) { return table[code]; });
}

void addShifted(Sha256& hash, std::span<const std::uint16_t> bits, bool isSigned, int shift)
{
    if (isSigned)
        addConverted(hash, bits,
            [shift](std::uint16_t each) { return float(int(std::int16_t(each)) + shift); });
    else
        addConverted(hash, bits, [shift](std::uint16_t each) { return float(int(each) + shift); });
}

} // namespace core
