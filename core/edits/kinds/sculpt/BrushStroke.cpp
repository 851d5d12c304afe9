// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/BrushStroke.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/sculpt/CutParts.h"
#include "core/edits/open/OpenBrush.h"

namespace core {

using namespace rowWords;

Result<void> check(const BrushStroke& edit, const Document& document)
{
    return checkCut(edit, "brush.layer", capsuleCut(edit, document), document);
}

Result<bool> apply(const BrushStroke&, Document&)
{
    return false;
}

EditEffects effects(const BrushStroke&)
{
    return {.task = engineTask<BrushStroke>(),
        .standsOpen = opens<BrushStroke>(),
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<CapsuleCut> capsuleCut(const BrushStroke& stroke, const Document& document)
{
    const Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, document.volumes.front().geometry, QStringLiteral("brush"));
    if (!frame)
        return tl::unexpected(frame.error());
    if (const Result<void> checked =
            checkProtected(stroke.protectedSegments, stroke.restore, QStringLiteral("brush"));
        !checked)
        return tl::unexpected(checked.error());
    CapsuleCut cut;
    cut.layer = std::uint8_t(stroke.layer);
    cut.restore = stroke.restore;
    cut.frame = *frame;
    cut.hidden = integerHalfSpaces(stroke.hidden, document.volumes.front().geometry);
    cut.protectedLabels = protectedLabelsOf(stroke.protectedSegments, document);
    return cut;
}

Result<EngineEdit> engineEdit(const BrushStroke& edit, const Document& document)
{
    return engineEditFrom(capsuleCut(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(BrushStroke& edit)
{
    return std::make_unique<OpenBrush>(edit.path);
}

RowTitle rowTitle(const BrushStroke& edit, const RowFacts& row)
{
    return {.code = edit.restore ? RowTitleCode::RestoreBrush : RowTitleCode::CarveBrush,
        .arguments = {inMm(edit.path.radiusMm)},
        .then = {figure(RowTitleCode::Voxels, row.statistics.voxelsChanged)}};
}

/// The coverage of its own layer in the bricks under the brush, and what it protects there.
EditDependencies dependencies(const BrushStroke& edit, const DependencyFacts& row)
{
    const std::bitset<256> labelsRead = labelsReadBy(edit, row.document);
    dependsOn::Bricks bricks;
    for (const std::uint32_t brick : row.under(edit.path)) {
        bricks.keys.insert({Field::Coverage, std::uint8_t(edit.layer), brick});
        for (std::size_t plane = 0; plane < labelsRead.size(); ++plane) {
            if (labelsRead[plane])
                bricks.keys.insert({Field::Labels, std::uint8_t(plane), brick});
        }
    }
    return bricks;
}

} // namespace core
