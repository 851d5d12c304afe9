// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/PastCoverage.h"

#include "core/edits/sculpt/CutAlone.h"
#include "core/engine/EngineCommands.h"

#include <algorithm>
#include <set>
#include <utility>

namespace core {

namespace {

constexpr std::uint8_t scratchLayer = 255;

bool isOfCuts(const BrickKey& key)
{
    return key.field == Field::Coverage && key.plane == scratchLayer;
}

} // namespace

PastCoverage::PastCoverage(std::vector<RowId> path, bool labels)
    : m_path(std::move(path))
    , m_labels(labels)
    , m_place(m_path.size())
{
}

void PastCoverage::addDifferences(RowId row, std::vector<BrickImage>&& differences)
{
    std::vector<BrickImage>& kept = m_differences[row];
    for (BrickImage& difference : differences) {
        if (difference.key.field == Field::Coverage
            || (m_labels && difference.key.field == Field::Labels))
            kept.push_back(std::move(difference));
    }
}

std::vector<BrickKey> PastCoverage::keys() const
{
    std::set<BrickKey> keys;
    for (const auto& [row, differences] : m_differences) {
        for (const BrickImage& difference : differences)
            keys.insert(difference.key);
    }
    return {keys.begin(), keys.end()};
}

void PastCoverage::addImages(const std::vector<BrickChange>& read)
{
    for (const BrickChange& brick : read) {
        m_images[brick.key] = {brick.key, brick.after};
        m_atPosition[brick.key] = brick.after;
    }
}

void PastCoverage::walk(std::size_t place)
{
    const auto layOver = [this](RowId row) {
        for (const BrickImage& difference : m_differences[row]) {
            BrickImage& image = m_images.at(difference.key);
            image = exclusiveOr(image, difference);
            m_toPut[difference.key] = image;
        }
    };
    for (; m_place > place; --m_place)
        layOver(m_path[m_place - 1]);
    for (; m_place < place; ++m_place)
        layOver(m_path[m_place]);
}

SwapBricks PastCoverage::takeToPut()
{
    SwapBricks swap;
    for (auto& [key, image] : m_toPut) {
        m_touched.insert(key);
        swap.bricks.push_back(std::move(image));
    }
    m_toPut.clear();
    return swap;
}

void PastCoverage::put(SessionState& state)
{
    if (!m_toPut.empty())
        state.engine.submit(takeToPut());
}

MuteLayers PastCoverage::mutedAt(const SessionState& state, RowId at)
{
    MuteLayers mute;
    const Document document = state.documentAt(at);
    for (const SculptLayer& layer : document.layers)
        mute.muted[layer.id] = !document.carves(layer);
    return mute;
}

void PastCoverage::walkBefore(RowId row)
{
    walk(std::size_t(std::find(m_path.begin(), m_path.end(), row) - m_path.begin()));
}

void PastCoverage::putBefore(SessionState& state, RowId row)
{
    put(state);
    state.engine.submit(mutedAt(state, state.history.row(row).parent));
}

void PastCoverage::overlay(SessionState& state, const std::map<BrickKey, BrickImage>& images)
{
    m_toPut = images;
    put(state);
    // What goes back with the next walk.
    for (const auto& [key, image] : images)
        m_toPut[key] = m_images.at(key);
}

Result<Ticket> PastCoverage::cut(SessionState& state, const SculptEdit& edit)
{
    Result<WholeCut> cut = cutAlone(edit, state.document, scratchLayer);
    if (!cut)
        return tl::unexpected(cut.error());
    return submitWhole(state.engine, std::move(cut->edit), std::move(cut->extensions));
}

StrokeCut PastCoverage::cutOf(EngineResult&& result)
{
    m_lastCut = std::move(result.changes);
    StrokeCut cut;
    for (const BrickChange& change : m_lastCut) {
        cut[change.key.brick] = change.after;
        m_toPut[change.key] = {change.key, {}};
    }
    m_lastCut.clear();
    return cut;
}

void PastCoverage::discard(const EngineResult& result)
{
    for (const BrickChange& change : result.changes) {
        if (isOfCuts(change.key))
            m_toPut[change.key] = {change.key, {}};
    }
}

void PastCoverage::restore(SessionState& state)
{
    // What was worked out and not put has never reached the engine; cuts have.
    std::erase_if(m_toPut, [](const auto& brick) { return !isOfCuts(brick.first); });
    for (const BrickChange& change : m_lastCut)
        m_toPut[change.key] = {change.key, {}};
    // All that was ever put, since on the way some of it may have been refused.
    for (const BrickKey& key : m_touched)
        m_toPut[key] = {key, isOfCuts(key) ? BrickBytes() : m_atPosition.at(key)};
    if (!m_toPut.empty())
        state.require(takeToPut());
    state.require(mutedAt(state, state.history.position()));
}

} // namespace core
