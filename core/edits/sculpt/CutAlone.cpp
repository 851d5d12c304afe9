// SPDX-License-Identifier: Apache-2.0
#include "core/edits/sculpt/CutAlone.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/sculpt/SculptVisit.h"

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

Result<WholeCut> wholeCut(const DrillStroke& stroke, const Document& document, std::uint8_t layer)
{
    Result<DrillCut> cut = drillCut(stroke, document);
    if (!cut)
        return tl::unexpected(cut.error());
    DrillPath path{drillPath(stroke, *cut)};
    return alone(*std::move(cut), layer, std::move(path));
}

Result<WholeCut> wholeCut(const LaserStroke& stroke, const Document& document, std::uint8_t layer)
{
    Result<LaserCut> cut = laserCut(stroke, document);
    if (!cut)
        return tl::unexpected(cut.error());
    DrillPath path{laserPath(stroke, *cut)};
    return alone(*std::move(cut), layer, std::move(path));
}

Result<WholeCut> wholeCut(const BrushStroke& stroke, const Document& document, std::uint8_t layer)
{
    Result<CapsuleCut> cut = capsuleCut(stroke, document);
    if (!cut)
        return tl::unexpected(cut.error());
    cut->layer = layer;
    cut->restore = false;
    return WholeCut{
        *std::move(cut), {CapsulePath{capsules(stroke.path, document.volumes.front().geometry)}}};
}

Result<WholeCut> wholeCut(const PeelCut& peel, const Document& document, std::uint8_t layer)
{
    Result<ShellPeel> cut = shellPeel(peel, document);
    if (!cut)
        return tl::unexpected(cut.error());
    return alone(*std::move(cut), layer, peelDepth(peel));
}

Result<WholeCut> wholeCut(const ScissorsCut& scissors, const Document& document, std::uint8_t layer)
{
    Result<OutlineCut> cut = outlineCut(scissors, document);
    if (!cut)
        return tl::unexpected(cut.error());
    cut->layer = layer;
    cut->laying = Laying::Carve;
    return WholeCut{*std::move(cut), {}};
}

} // namespace

Result<WholeCut> cutAlone(const SculptEdit& edit, const Document& document, std::uint8_t layer)
{
    return visitSculpt(
        [&](const auto& known) -> Result<WholeCut> { return wholeCut(known, document, layer); },
        edit);
}

} // namespace core
