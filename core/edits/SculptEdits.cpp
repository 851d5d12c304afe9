// SPDX-License-Identifier: Apache-2.0
#include "core/edits/SculptEdits.h"

#include "core/edits/DrillPathSampler.h"
#include "core/edits/EngineEdits.h"

#include <type_traits>
#include <utility>

namespace core {

namespace {

/// Into another layer, and carving.
template <class Cut> WholeCut alone(Cut cut, std::uint8_t layer, EngineExtension extension)
{
    cut.layer = layer;
    cut.laying = Laying::Carve;
    return {std::move(cut), {std::move(extension)}};
}

Result<WholeCut> cutAlone(const DrillStroke& stroke, const Document& document, std::uint8_t layer)
{
    Result<DrillCut> cut = drillCut(stroke, document);
    if (!cut)
        return tl::unexpected(cut.error());
    DrillPath path{drillPath(stroke, *cut)};
    return alone(*std::move(cut), layer, std::move(path));
}

Result<WholeCut> cutAlone(const BrushStroke& stroke, const Document& document, std::uint8_t layer)
{
    Result<CapsuleCut> cut = capsuleCut(stroke, document);
    if (!cut)
        return tl::unexpected(cut.error());
    cut->layer = layer;
    cut->restore = false;
    return WholeCut{
        *std::move(cut), {CapsulePath{capsules(stroke.path, document.volumes.front().geometry)}}};
}

Result<WholeCut> cutAlone(const PeelCut& peel, const Document& document, std::uint8_t layer)
{
    Result<MaskPeel> cut = maskPeel(peel, document);
    if (!cut)
        return tl::unexpected(cut.error());
    return alone(*std::move(cut), layer, peelDepth(peel));
}

Result<WholeCut> cutAlone(const ScissorsCut& scissors, const Document& document, std::uint8_t layer)
{
    Result<MaskScissors> cut = maskScissors(scissors, document);
    if (!cut)
        return tl::unexpected(cut.error());
    cut->layer = layer;
    cut->laying = Laying::Carve;
    return WholeCut{*std::move(cut), {}};
}

} // namespace

std::optional<SculptEdit> sculptEdit(const Edit& edit)
{
    return std::visit(
        [](const auto& known) -> std::optional<SculptEdit> {
            using E = std::decay_t<decltype(known)>;
            if constexpr (std::is_constructible_v<SculptEdit, E>)
                return SculptEdit(known);
            else
                return std::nullopt;
        },
        edit);
}

Edit plainEdit(const SculptEdit& edit)
{
    return std::visit([](const auto& known) { return Edit(known); }, edit);
}

int layerOf(const SculptEdit& edit)
{
    return std::visit([](const auto& known) { return known.layer; }, edit);
}

bool restores(const SculptEdit& edit)
{
    return std::visit([](const auto& known) { return known.restore; }, edit);
}

Result<WholeCut> cutAlone(const SculptEdit& edit, const Document& document, std::uint8_t layer)
{
    return std::visit(
        [&](const auto& known) -> Result<WholeCut> { return cutAlone(known, document, layer); },
        edit);
}

} // namespace core
