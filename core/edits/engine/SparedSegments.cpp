// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/SparedSegments.h"

#include "core/edits/kinds/AnyEdit.h"

#include <set>
#include <type_traits>
#include <utility>

namespace core {

const SparedSegments* sparedBy(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> const SparedSegments* {
            using E = std::decay_t<decltype(known)>;
            if constexpr (
                std::is_same_v<E,
                    DrillStroke> || std::is_same_v<E, LaserStroke> || std::is_same_v<E, BrushStroke> || std::is_same_v<E, PeelCut> || std::is_same_v<E, ScissorsCut>) {
                return known.restore ? nullptr : &known.spared;
            } else {
                return nullptr;
            }
        },
        edit);
}

SparedSegments* sparedBy(Edit& edit)
{
    return const_cast<SparedSegments*>(sparedBy(std::as_const(edit)));
}

void spareProtected(Edit& edit, const Document& document)
{
    if (SparedSegments* spared = sparedBy(edit))
        spareProtected(*spared, document);
}

void spareProtected(SparedSegments& spared, const Document& document)
{
    std::set<int> all;
    if (spared)
        all.insert(spared->begin(), spared->end());
    for (const Segment& segment : document.segments) {
        if (segment.uncarvable)
            all.insert(segment.label);
    }
    if (!all.empty())
        spared.emplace(all.begin(), all.end());
}

SparedLabels sparedLabels(const SparedSegments& spared, const Document& document)
{
    SparedLabels labels;
    labels.plane = document.growths.empty() ? std::uint8_t(0) : document.growths.front().plane;
    if (!spared)
        return labels;
    for (const int label : *spared)
        labels.labels.set(std::size_t(label));
    return labels;
}

Result<void> checkSpared(const SparedSegments& spared, bool restore, const QString& edit)
{
    if (spared && restore)
        return failure(ErrorCode::InvalidField, edit + QStringLiteral(".spared"),
            QStringLiteral("has no meaning while restoring"));
    return {};
}

} // namespace core
