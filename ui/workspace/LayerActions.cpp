// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/LayerActions.h"

#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/ShownValues.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>

namespace ui {

namespace {

/// "Sculpt 3": the first such name that is free.
QString nextLayerName(const core::Document& document)
{
    for (qsizetype number = qsizetype(document.layers.size()) + 1;; ++number) {
        const QString name = QObject::tr("Sculpt %1").arg(number);
        const bool taken = std::any_of(document.layers.begin(), document.layers.end(),
            [&name](const core::SculptLayer& layer) { return layer.name == name; });
        if (!taken)
            return name;
    }
}

} // namespace

core::Result<int> addLayer(Workspace& workspace)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return core::failure(core::ErrorCode::Internal, core::Clause::saying("no study is open"));
    // While the engine is busy the new layer waits in line; its id is known all the same.
    const core::AddLayer edit{.name = nextLayerName(session->foreseenDocument())};
    if (const auto added = session->apply(edit); !added)
        return tl::unexpected(added.error());
    const int id = session->foreseenDocument().layers.back().id;
    workspace.layerLooks().setLook(id, {}); // not that of an undone one, whose number it takes
    workspace.setActiveLayer(id);
    return id;
}

QString carvingTarget(const Workspace& workspace, bool restores)
{
    const core::EditSession* session = workspace.session();
    const core::SculptLayer* layer =
        session ? session->document().layer(workspace.activeLayer()) : nullptr;
    if (!layer)
        return {};
    if (layer->muted)
        return QObject::tr("layer %1 is muted").arg(layer->name);
    if (!session->document().carves(*layer))
        return QObject::tr("layer %1 is left out").arg(layer->name);
    if (restores)
        return QObject::tr("restores layer %1").arg(layer->name);
    QString spared;
    int count = 0;
    for (const core::Segment& segment : session->document().segments) {
        if (segment.uncarvable && ++count == 1)
            spared = segment.name;
    }
    const QString target = QObject::tr("carves layer %1").arg(layer->name);
    return count == 0 ? target
        : count == 1  ? QObject::tr("%1, not %2").arg(target, spared)
                      : QObject::tr("%1, not %2 protected segments").arg(target).arg(count);
}

namespace {

void apply(Workspace& workspace, const core::Edit& edit)
{
    if (core::EditSession* session = workspace.session()) {
        if (const auto applied = session->apply(edit); !applied)
            workspace.fail(applied.error());
    }
}

core::SegmentChoice newSegment(const core::Document& document, const QString& name)
{
    return {.segment = {},
        .name = name.isEmpty() ? nextSegmentName(document) : name,
        .rgb = nextSegmentColour(document)};
}

/// Gives voxels to a segment and makes it the active one.
template <class E> void give(Workspace& workspace, E edit, std::optional<int> label)
{
    core::EditSession* session = workspace.session();
    if (const auto applied = session->apply(edit); !applied)
        return workspace.fail(applied.error());
    // A new one has its label before it has its voxels; without any, or if an undo that waits
    // before it leaves nothing to take, it will not come.
    const core::Document expected = session->foreseenDocument();
    if (label)
        workspace.setActiveSegment(*label);
    else if (!expected.segments.empty())
        workspace.setActiveSegment(expected.segments.back().label);
}

} // namespace

void removeLayer(Workspace& workspace, int id)
{
    if (!workspace.session())
        return;
    const core::Document before = workspace.session()->foreseenDocument();
    const core::SculptLayer* layer = before.layer(id);
    if (const auto removed = workspace.session()->apply(core::RemoveLayer{.layer = id}); !removed)
        return workspace.fail(removed.error());
    if (layer) // an undo that waits before it may bring it
        workspace.say(QObject::tr("Deleted layer '%1'; Ctrl+Z brings it back").arg(layer->name));
}

void mergeLayers(Workspace& workspace, int from, int into)
{
    if (!workspace.session())
        return;
    const auto merged = workspace.session()->apply(core::MergeLayers{.from = from, .into = into});
    if (!merged)
        return workspace.fail(merged.error());
    workspace.setActiveLayer(into);
}

void layerToSegment(Workspace& workspace, int layer, std::optional<int> label)
{
    if (!workspace.session())
        return;
    const core::Document document = workspace.session()->foreseenDocument();
    const core::SculptLayer* source = document.layer(layer);
    if (!source)
        return;
    core::LayerToSegment edit{.layer = layer, .target = {.segment = label}};
    if (!label)
        edit.target = newSegment(document, source->name);
    edit.editable = workspace.editableRange();
    give(workspace, edit, label);
}

QString whyNotCarved(const core::Document& document, int label, bool outside)
{
    const core::Segment* segment = document.segment(label);
    if (!segment)
        return {};
    if (!outside && segment->uncarvable)
        return QObject::tr("'%1' is protected from sculpting").arg(segment->name);
    for (const core::Segment& each : document.segments) {
        if (each.uncarvable && each.plane != segment->plane)
            return QObject::tr("'%1' is protected from sculpting and lies on another label plane, "
                               "where it may have the same voxels")
                .arg(each.name);
    }
    return {};
}

void segmentToLayer(Workspace& workspace, int label, int layer, bool outside)
{
    apply(workspace,
        core::SegmentToLayer{.segment = label,
            .layer = layer,
            .outside = outside ? std::optional(true) : std::nullopt});
}

void segmentWhatIsSeen(Workspace& workspace, std::optional<int> label)
{
    if (!workspace.session())
        return;
    const ShownValues shown = shownValues(workspace.volumeDisplay());
    if (!shown.why.isEmpty())
        return workspace.say(shown.why);
    core::SegmentSeen edit{.target = {.segment = label}, .lower = shown.lower};
    edit.upper = shown.upper;
    edit.hidden = core::clipHalfSpaces(shownClip(workspace), workspace.volume()->geometry);
    if (!label)
        edit.target = newSegment(workspace.session()->foreseenDocument(), {});
    edit.editable = workspace.editableRange();
    give(workspace, edit, label);
}

} // namespace ui
