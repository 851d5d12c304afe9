// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/ProtectedVoxels.h"

#include "core/edits/engine/SparedSegments.h"
#include "core/edits/kinds/parts/SparedSegments.h"

#include <map>
#include <set>

namespace core {

namespace {

SparedLabels protectedLabels(const Document& document)
{
    SparedSegments all;
    spareProtected(all, document);
    return sparedLabels(all, document);
}

} // namespace

std::vector<BrickKey> labelsOverCoverage(
    const Document& document, const std::vector<BrickImage>& coverage)
{
    const SparedLabels spared = protectedLabels(document);
    std::set<BrickKey> keys;
    for (const BrickImage& image : coverage) {
        if (spared.labels.any() && image.key.field == Field::Coverage)
            keys.insert({Field::Labels, spared.plane, image.key.brick});
    }
    return {keys.begin(), keys.end()};
}

Result<void> checkProtected(const Document& document, const std::vector<BrickChange>& now,
    const std::vector<BrickImage>& then)
{
    const SparedLabels spared = protectedLabels(document);
    std::map<BrickKey, const std::vector<std::uint8_t>*> known;
    for (const BrickChange& brick : now)
        known[brick.key] = &brick.after;
    for (const BrickImage& coming : then) {
        const auto held = known.find(coming.key);
        const auto labels = known.find({Field::Labels, spared.plane, coming.key.brick});
        if (coming.key.field != Field::Coverage || coming.bytes.empty() || held == known.end()
            || labels == known.end() || labels->second->empty())
            continue;
        for (std::size_t i = 0; i < coming.bytes.size(); ++i) {
            const std::uint8_t label = (*labels->second)[i];
            const int carved = held->second->empty() ? 0 : (*held->second)[i];
            if (spared.labels.test(label) && coming.bytes[i] > carved)
                return failure(ErrorCode::SegmentProtected, document.segment(label)->name);
        }
    }
    return {};
}

} // namespace core
