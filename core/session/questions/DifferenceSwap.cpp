// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/DifferenceSwap.h"

#include <algorithm>
#include <utility>

namespace core {

void DifferenceSwap::start(SessionState& state, std::vector<BrickImage> differences, Check check)
{
    m_check = std::move(check);
    m_differences = std::move(differences);
    std::stable_sort(m_differences.begin(), m_differences.end(),
        [](const BrickImage& a, const BrickImage& b) { return a.key < b.key; });
    ReadBricks read;
    for (const BrickImage& difference : m_differences) {
        if (read.keys.empty() || read.keys.back() != difference.key)
            read.keys.push_back(difference.key);
    }
    m_reading = state.engine.submit(std::move(read));
}

void DifferenceSwap::put(SessionState& state, std::vector<BrickImage> images)
{
    m_swapping = state.engine.submit(SwapBricks{std::move(images)});
}

std::optional<Result<EngineResult>> DifferenceSwap::takeResult(
    SessionState& state, EngineResult&& result)
{
    const bool read = m_reading && result.ticket == *m_reading;
    const bool swapped = m_swapping && result.ticket == *m_swapping;
    if (!read && !swapped)
        return std::nullopt;
    if (result.error)
        return tl::unexpected(*result.error);
    if (swapped) {
        m_swapping.reset();
        return std::move(result);
    }
    m_reading.reset();
    std::vector<BrickImage> images;
    images.reserve(result.changes.size());
    auto difference = m_differences.begin();
    for (const BrickChange& now : result.changes) {
        BrickImage image{now.key, now.after};
        for (; difference != m_differences.end() && difference->key == now.key; ++difference)
            image = exclusiveOr(image, *difference);
        images.push_back(std::move(image));
    }
    m_differences.clear();
    if (m_check) {
        if (const Result<void> checked = m_check(result.changes, images); !checked)
            return tl::unexpected(checked.error());
    }
    put(state, std::move(images));
    return std::nullopt;
}

} // namespace core
