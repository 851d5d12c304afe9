// SPDX-License-Identifier: Apache-2.0
#include "core/islands/RunParts.h"

#include <algorithm>
#include <numeric>

namespace core {

RunParts::RunParts(const glm::ivec3& size, int touch)
    : m_size(size)
    , m_touch(touch)
    , m_firstOfRow(std::size_t(size.y) * std::size_t(size.z) + 1, 0)
{
}

void RunParts::add(int begin, int end)
{
    m_runs.push_back({begin, end});
    m_parent.push_back(std::uint32_t(m_parent.size()));
}

void RunParts::gather(std::vector<std::vector<Run>>& slices)
{
    std::vector<std::size_t> firsts;
    firsts.reserve(slices.size());
    std::size_t count = 0;
    for (const std::vector<Run>& runs : slices) {
        firsts.push_back(count);
        count += runs.size();
    }
    m_runs.resize(count);
    m_parent.resize(count);
    std::iota(m_parent.begin(), m_parent.end(), std::uint32_t(0));
    parallelFor(m_size.z, [&](int z) {
        std::vector<Run>& runs = slices[std::size_t(z)];
        const std::size_t first = firsts[std::size_t(z)];
        std::copy(runs.begin(), runs.end(), m_runs.begin() + std::ptrdiff_t(first));
        runs = {};
        for (int y = 0; y < m_size.y; ++y)
            m_firstOfRow[rowAt(y, z)] += first;
    });
    endRows();
}

/// Slabs of slices are joined within themselves first. A part is called after its first run, so
/// what a slab joins never leads out of it, and the result does not depend on the order of joining.
bool RunParts::join(const Progress& progress)
{
    constexpr int slab = 16;
    parallelFor((m_size.z + slab - 1) / slab, [&](int number) {
        const int begin = number * slab;
        const int end = std::min(begin + slab, m_size.z);
        for (int z = begin; z < end && !progress.cancelled(); ++z) {
            joinWithin(z);
            if (z > begin)
                joinWithBefore(z);
        }
    });
    for (int z = slab; z < m_size.z && !progress.cancelled(); z += slab)
        joinWithBefore(z);
    if (progress.cancelled())
        return false;
    // From here on each run knows its part: those before it do, and its parent is one of them.
    for (std::uint32_t& parent : m_parent)
        parent = m_parent[parent];
    return true;
}

void RunParts::joinWithin(int z)
{
    for (int y = 1; y < m_size.y; ++y)
        joinRows(rowAt(y, z), rowAt(y - 1, z));
}

void RunParts::joinWithBefore(int z)
{
    for (int y = 0; y < m_size.y; ++y) {
        const std::size_t row = rowAt(y, z);
        joinRows(row, rowAt(y, z - 1));
        if (m_touch > 0 && y > 0)
            joinRows(row, rowAt(y - 1, z - 1));
        if (m_touch > 0 && y + 1 < m_size.y)
            joinRows(row, rowAt(y + 1, z - 1));
    }
}

std::uint32_t RunParts::partOf(std::size_t run)
{
    auto root = std::uint32_t(run);
    while (m_parent[root] != root) {
        m_parent[root] = m_parent[m_parent[root]];
        root = m_parent[root];
    }
    return root;
}

std::optional<std::uint32_t> RunParts::partAt(const glm::ivec3& voxel)
{
    const std::size_t row = rowAt(voxel.y, voxel.z);
    for (std::size_t at = m_firstOfRow[row]; at < m_firstOfRow[row + 1]; ++at) {
        if (m_runs[at].begin <= voxel.x && voxel.x < m_runs[at].end)
            return partOf(at);
    }
    return std::nullopt;
}

void RunParts::joinRows(std::size_t row, std::size_t other)
{
    std::size_t one = m_firstOfRow[row];
    std::size_t two = m_firstOfRow[other];
    while (one < m_firstOfRow[row + 1] && two < m_firstOfRow[other + 1]) {
        const bool touches = m_runs[one].begin < m_runs[two].end + m_touch
            && m_runs[two].begin < m_runs[one].end + m_touch;
        if (touches)
            joinRuns(one, two);
        if (m_runs[one].end < m_runs[two].end)
            ++one;
        else
            ++two;
    }
}

/// The smaller number stays, so that a part is called after its first run.
void RunParts::joinRuns(std::size_t one, std::size_t two)
{
    const std::uint32_t first = partOf(one);
    const std::uint32_t second = partOf(two);
    m_parent[std::max(first, second)] = std::min(first, second);
}

} // namespace core
