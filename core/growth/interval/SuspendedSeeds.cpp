// SPDX-License-Identifier: Apache-2.0
#include "core/growth/interval/SuspendedSeeds.h"

#include <algorithm>

namespace core {

namespace {

constexpr int greatestCode = 65535;

} // namespace

SuspendedSeeds::SuspendedSeeds(std::span<const Voxel> voxels, std::span<const std::uint16_t> codes)
    : m_voxels(voxels.size())
    , m_first(std::size_t(greatestCode) + 2, 0)
{
    for (const std::uint16_t code : codes)
        ++m_first[std::size_t(code) + 1];
    for (std::size_t code = 1; code < m_first.size(); ++code)
        m_first[code] += m_first[code - 1];
    std::vector<std::uint32_t> next = m_first;
    for (std::size_t i = 0; i < voxels.size(); ++i)
        m_voxels[next[codes[i]]++] = voxels[i];
}

std::span<const SuspendedSeeds::Voxel> SuspendedSeeds::within(int low, int high) const
{
    const int least = std::max(low, 0);
    const int greatest = std::min(high, greatestCode);
    if (m_voxels.empty() || least > greatest)
        return {};
    const std::uint32_t first = m_first[std::size_t(least)];
    return std::span(m_voxels).subspan(first, m_first[std::size_t(greatest) + 1] - first);
}

} // namespace core
