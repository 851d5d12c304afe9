// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/WholeImageUndo.h"

#include <algorithm>

namespace peer {

RunLengthImage::RunLengthImage(std::span<const std::uint8_t> voxels, std::size_t rowLength)
{
    for (std::size_t row = 0; row < voxels.size(); row += rowLength) {
        const auto end = voxels.begin() + std::ptrdiff_t(row + rowLength);
        for (auto at = voxels.begin() + std::ptrdiff_t(row); at != end;) {
            const std::uint8_t value = *at;
            const auto next =
                std::find_if(at, end, [value](std::uint8_t other) { return other != value; });
            m_runs.push_back({std::uint16_t(next - at), value});
            at = next;
        }
    }
}

void RunLengthImage::decode(std::span<std::uint8_t> voxels) const
{
    auto at = voxels.begin();
    for (const Run& run : m_runs)
        at = std::fill_n(at, run.length, run.value);
}

RunLengthDifference::RunLengthDifference(
    std::span<const std::uint8_t> before, std::span<const std::uint8_t> after)
{
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::uint8_t value = before[i] ^ after[i];
        if (m_runs.empty() || m_runs.back().value != value)
            m_runs.push_back({0, value});
        ++m_runs.back().length;
    }
}

void RunLengthDifference::apply(std::span<std::uint8_t> voxels) const
{
    std::size_t at = 0;
    for (const Run& run : m_runs) {
        if (run.value != 0) {
            for (std::size_t i = at; i < at + run.length; ++i)
                voxels[i] ^= run.value;
        }
        at += run.length;
    }
}

} // namespace peer
