// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/GpuEditEngine.h"

#include "gpu/fields/BrickImages.h"
#include "gpu/gl/GlFailure.h"

namespace gpu {

// GpuEditEngine, the part that puts bricks in place, and mutes layers of them: what the session
// asks for that is no edit.

core::Result<void> GpuEditEngine::checkKeys(std::span<const core::BrickKey> keys) const
{
    for (const core::BrickKey& key : keys) {
        const bool known = key.field == core::Field::Coverage || key.field == core::Field::Labels
            || key.field == core::Field::SeedWords || key.field == core::Field::Overwritten;
        if (!known || key.brick >= std::uint32_t(m_fields->grid().brickCount()))
            return refusal("brick", core::Clause::saying("not in this volume"));
    }
    return {};
}

core::Result<void> GpuEditEngine::checkImages(
    const std::vector<core::BrickImage>& images, bool mayBeEmpty) const
{
    if (m_transaction)
        return refusal("transaction", core::Clause::saying("an edit is open"));
    for (const core::BrickImage& image : images) {
        const bool isWhole = image.bytes.size() == packedBrickBytes(image.key.field);
        if (const core::Result<void> checked = checkKeys({&image.key, 1}); !checked)
            return checked;
        if (!isWhole && !(mayBeEmpty && image.bytes.empty()))
            return refusal("bytes", core::Clause::saying("neither none nor a whole brick"));
    }
    return {};
}

/// @param now the bricks that had to be read for it, sorted by key
GpuEditEngine::Outcome GpuEditEngine::put(const core::LabelGuard& guard,
    const std::vector<core::BrickImage>& now, std::vector<core::BrickImage> images)
{
    if (const core::Result<void> checked = core::checkGuard(guard, now, images); !checked)
        return tl::unexpected(checked.error());
    hideTolerance();
    m_cutPreviewer.forget();
    m_growthMarks.forget();
    std::vector<core::BrickImage> held;
    held.reserve(images.size());
    core::EngineResult result;
    result.changes = exchangeImages(*m_fields, now, std::move(images));
    try {
        result.facts = core::factsOf(result.changes, m_fields->grid());
    } catch (const std::exception&) {
        // No memory to count in: what is refused has changed nothing.
        for (const core::BrickChange& change : result.changes)
            held.push_back({.key = change.key, .bytes = change.before});
        putBackImages(*m_fields, held);
        throw;
    }
    result.statistics = core::statisticsOf(result.facts);
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(core::SwapBricks& command)
{
    if (const core::Result<void> checked = checkImages(command.bricks, true); !checked)
        return tl::unexpected(checked.error());
    const std::vector<core::BrickImage> now =
        imagesNow(*m_fields, core::bricksToRead(command.bricks, command.guard));
    return put(command.guard, now, std::move(command.bricks));
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(core::XorBricks& command)
{
    if (const core::Result<void> checked = checkImages(command.differences, false); !checked)
        return tl::unexpected(checked.error());
    const std::vector<core::BrickImage> now =
        imagesNow(*m_fields, core::bricksToRead(command.differences, command.guard));
    return put(command.guard, now, core::laidOver(command.differences, now));
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::MuteLayers& command)
{
    if (m_transaction)
        return refusal("transaction", core::Clause::saying("an edit is open"));
    hideTolerance();
    const std::bitset<256> before = m_fields->mutedLayers();
    try {
        m_fields->setMutedLayers(command.muted);
        requireNoError();
    } catch (const std::exception&) {
        const core::Error error = errorBeingHandled();
        try {
            m_fields->setMutedLayers(before);
            requireNoError();
        } catch (const std::exception&) {
            throw FieldsLost(error);
        }
        throw GlFailure(error);
    }
    return core::EngineResult{};
}

} // namespace gpu
