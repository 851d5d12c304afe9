// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/ChunkVoxels.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/SparedSegments.h"

namespace core {

namespace {

/// A stroke into a layer that is not there or not seen would be lost work.
Result<void> checkLayer(const char* field, int id, const Document& document)
{
    const SculptLayer* layer = document.layer(id);
    if (!layer)
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            QStringLiteral("there is no sculpt layer %1").arg(id));
    if (const QString why = document.whyItDoesNotCarve(*layer); !why.isEmpty())
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            QStringLiteral("sculpt layer '%1' %2: what is carved there would not be seen")
                .arg(layer->name, why));
    return {};
}

Result<void> checkSparedAreThere(const Edit& edit, const Document& document)
{
    const SparedSegments* spared = sparedBy(edit);
    if (!spared || !*spared)
        return {};
    for (const int label : **spared) {
        if (!document.segment(label))
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                QStringLiteral("in field 'spared'"));
    }
    return {};
}

template <class T> Result<void> discardValue(const Result<T>& result)
{
    if (!result)
        return tl::unexpected(result.error());
    return {};
}

} // namespace

Result<void> checkAgainst(const Document& document, const Edit& edit)
{
    if (changedPart(edit) || std::holds_alternative<SurfaceBarrier>(edit)) {
        Document copy = document;
        if (const Result<bool> applied = applyToDocument(edit, copy); !applied)
            return tl::unexpected(applied.error());
    }
    if (const Result<void> checked = checkSparedAreThere(edit, document); !checked)
        return checked;
    if (const auto* carved = std::get_if<LayerToSegment>(&edit))
        return discardValue(labelCarved(*carved, document));
    if (const auto* seen = std::get_if<SegmentSeen>(&edit))
        return discardValue(labelSeen(*seen, document));
    if (const auto* mask = std::get_if<ImportMask>(&edit))
        return discardValue(labelListed(*mask, document));
    if (const auto* chunks = std::get_if<Chunks>(&edit); chunks && chunks->owners)
        return discardValue(ownedBox(*chunks, document.volumes.front().geometry));
    if (const auto* toggle = std::get_if<ChunkToggle>(&edit))
        return discardValue(chunkClick(*toggle, document));
    if (const auto* cover = std::get_if<SegmentToLayer>(&edit)) {
        if (const Result<void> checked = checkLayer("segmentToLayer.layer", cover->layer, document);
            !checked)
            return checked;
        return discardValue(coverLabel(*cover, document));
    }
    if (const auto* seed = std::get_if<SeedStroke>(&edit))
        return discardValue(seedPlacement(*seed, document));
    if (const auto* grow = std::get_if<GrowSteps>(&edit))
        return discardValue(growBurst(*grow, document));
    if (const auto* shrink = std::get_if<ShrinkSteps>(&edit))
        return discardValue(shrinkGrowth(*shrink, document));
    if (const auto* shrink = std::get_if<ShrinkAt>(&edit))
        return discardValue(cutGrowth(*shrink, document));
    if (const auto* plug = std::get_if<PlugLeak>(&edit))
        return discardValue(cutGrowth(*plug, document));
    if (const auto* spread = std::get_if<GrowFromSeeds>(&edit))
        return discardValue(spreadLabels(*spread, document));
    if (const auto* drill = std::get_if<DrillStroke>(&edit)) {
        if (const Result<void> checked = checkLayer("drill.layer", drill->layer, document);
            !checked)
            return checked;
        return discardValue(drillCut(*drill, document));
    }
    if (const auto* laser = std::get_if<LaserStroke>(&edit)) {
        if (const Result<void> checked = checkLayer("laser.layer", laser->layer, document);
            !checked)
            return checked;
        return discardValue(laserCut(*laser, document));
    }
    if (const auto* paint = std::get_if<PaintStroke>(&edit))
        return discardValue(paintLabel(*paint, document));
    if (const auto* barrier = std::get_if<BarrierStroke>(&edit))
        return discardValue(paintBarrier(*barrier, document));
    if (const auto* change = std::get_if<ChangeInterval>(&edit))
        return discardValue(growBurst(*change, document));
    if (const auto* brush = std::get_if<BrushStroke>(&edit)) {
        if (const Result<void> checked = checkLayer("brush.layer", brush->layer, document);
            !checked)
            return checked;
        return discardValue(capsuleCut(*brush, document));
    }
    if (const auto* peel = std::get_if<PeelCut>(&edit)) {
        if (const Result<void> checked = checkLayer("peel.layer", peel->layer, document); !checked)
            return checked;
        return discardValue(maskPeel(*peel, document));
    }
    if (const auto* cut = std::get_if<ScissorsCut>(&edit)) {
        if (const Result<void> checked = checkLayer("scissors.layer", cut->layer, document);
            !checked)
            return checked;
        return discardValue(maskScissors(*cut, document));
    }
    return {}; // "undo only" and revisions read the history, not the document
}

} // namespace core
