// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/PeelCut.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/CutParts.h"
#include "core/edits/kinds/sculpt/OutlinedPlane.h"
#include "core/edits/open/OpenStroke.h"
#include "core/edits/open/StrokeExtension.h"

#include <utility>

namespace core {

using namespace rowWords;

namespace {

/// No peel reaches farther than this along the view, however steep the surface.
constexpr double farthestPeelMm = 64.0;

/// An open peel can be set to another depth (ToDepth) until it is closed.
class OpenPeel final : public OpenStroke {
public:
    explicit OpenPeel(PeelCut& peel)
        : m_peel(peel)
    {
    }
    [[nodiscard]] OpenManner manner() const override
    {
        return {.withoutPen = true, .usualEnding = Ending::Commit};
    }
    [[nodiscard]] Told begin(const EngineEdit&, const Document&, bool) override
    {
        m_hasBegun = true;
        return {peelDepth(m_peel)};
    }
    [[nodiscard]] Result<Told> extend(const StrokeExtension& extension, const Document&) override
    {
        Told told;
        const auto* to = std::get_if<ToDepth>(&extension);
        if (!to || m_peel.depthMm == to->mm)
            return told;
        m_peel.depthMm = to->mm;
        if (m_hasBegun)
            told.push_back(peelDepth(m_peel));
        return told;
    }

private:
    PeelCut& m_peel;
    bool m_hasBegun = false;
};

} // namespace

Result<void> check(const PeelCut& edit, const Document& document)
{
    return checkCut(edit, "peel.layer", shellPeel(edit, document), document);
}

Result<bool> apply(const PeelCut&, Document&)
{
    return false;
}

EditEffects effects(const PeelCut&)
{
    return {.task = engineTask<PeelCut>(),
        .standsOpen = opens<PeelCut>(),
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<ShellPeel> shellPeel(const PeelCut& peel, const Document& document)
{
    Result<OutlinedPlane> plane = outlinedPlane(peel.polygonMm,
        {.view = peel.view,
            .surfaceThreshold = peel.surfaceThreshold,
            .maxDepthMm = farthestPeelMm,
            .throughGaps = peel.throughGaps,
            .restore = peel.restore,
            .hidden = peel.hidden,
            .protectedSegments = peel.protectedSegments},
        document, QStringLiteral("peel"));
    if (!plane)
        return tl::unexpected(plane.error());
    ShellPeel made{.layer = std::uint8_t(peel.layer), .frame = plane->frame};
    made.mask = std::move(plane->mask);
    if (peel.jumpMm > 0.0)
        made.jump = mm16(peel.jumpMm);
    made.laying = peel.restore ? Laying::Refill : Laying::Carve;
    return made;
}

PeelDepth peelDepth(const PeelCut& peel)
{
    return {mm16(peel.depthMm)};
}

Result<EngineEdit> engineEdit(const PeelCut& edit, const Document& document)
{
    return engineEditFrom(shellPeel(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(PeelCut& edit)
{
    return std::make_unique<OpenPeel>(edit);
}

/// "Peel 4.0 mm, 214 bricks".
RowTitle rowTitle(const PeelCut& peel, const RowFacts& row)
{
    return {.code = peel.restore ? RowTitleCode::RestorePeel : RowTitleCode::Peel,
        .arguments = {inMm(peel.depthMm)},
        .then = {figure(RowTitleCode::Bricks, row.statistics.bricks)}};
}

EditDependencies dependencies(const PeelCut& edit, const DependencyFacts& row)
{
    const Result<ShellPeel> cut = shellPeel(edit, row.document);
    if (!cut)
        return reachesNothing();
    return sweptOutline(cut->frame, edit.polygonMm, labelsReadBy(edit, row.document), row);
}

} // namespace core
