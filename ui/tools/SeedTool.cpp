// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/SeedTool.h"

#include "ui/PendingSeeds.h"
#include "ui/SegmentActions.h"
#include "ui/Workspace.h"
#include "ui/tools/SeedMarks.h"
#include "ui/tools/SeedOptions.h"

#include <QPainter>

namespace ui {

SeedTool::SeedTool(Workspace& workspace, QObject* parent)
    : SketchTool(workspace, parent)
{
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                Q_EMIT overlayChanged();
        });
    connect(&workspace.seeds(), &PendingSeeds::changed, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
}

QString SeedTool::name() const
{
    return tr("Seed");
}

QString SeedTool::iconName() const
{
    return QStringLiteral("seed");
}

QString SeedTool::hint() const
{
    return tr(
        "Seed: sketch on what belongs to the segment, in a slice or on the 3D view; then grow");
}

QString SeedTool::target() const
{
    const core::EditSession* session = workspace().session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(workspace().activeSegment());
    return segment ? tr("seeds for %1").arg(segment->name) : tr("seeds for a new segment");
}

QWidget* SeedTool::createOptions(QWidget* parent)
{
    return new SeedOptions(workspace(), tr("Seeds for"), parent);
}

void SeedTool::commit(const std::vector<glm::ivec3>& voxels)
{
    const core::Result<int> label = ensureActiveSegment(workspace());
    if (!label) {
        workspace().fail(label.error());
        return;
    }
    core::SeedStroke stroke;
    stroke.segment = *label;
    for (const glm::ivec3& voxel : voxels)
        stroke.pointsLps.push_back(workspace().volume()->geometry.toWorld(glm::dvec3(voxel)));
    if (const auto applied = workspace().session()->apply(stroke); !applied) {
        workspace().fail(applied.error());
        return;
    }
    const QString name = workspace().session()->foreseenDocument().segment(*label)->name;
    workspace().say(voxels.size() == 1 ? tr("One seed voxel for %1").arg(name)
                                       : tr("%1 seed voxels for %2").arg(voxels.size()).arg(name));
}

QColor SeedTool::colour() const
{
    const core::Document& document = workspace().session()->document();
    const core::Segment* segment = document.segment(workspace().activeSegment());
    return segment ? QColor(segment->rgb) : QColor(nextSegmentColour(document));
}

QString SeedTool::outsideText() const
{
    return tr("No seed was set: the sketch lies outside the volume");
}

QString SeedTool::nothingSeenText() const
{
    return tr("No seed was set: nothing is seen under the sketch");
}

void SeedTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (workspace().session() && view.isSlice())
        paintSeedMarks(painter, view, workspace());
    SketchTool::paintOverlay(painter, view);
}

} // namespace ui
