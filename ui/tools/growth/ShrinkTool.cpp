// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/ShrinkTool.h"

#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/RowTitleText.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/SketchedVoxels.h"
#include "ui/tools/growth/ShrinkPreview.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

namespace ui {

ShrinkTool::ShrinkTool(Workspace& workspace, QObject* parent)
    : SketchTool(workspace, parent)
    , m_sketched(new SketchedVoxels(workspace, this))
    , m_preview(new ShrinkPreview(workspace, this))
{
    connect(m_sketched, &SketchedVoxels::grew, this,
        [this] { m_preview->follow(m_sketched->voxels()); });
    connect(m_preview, &ShrinkPreview::changed, this, &Tool::overlayChanged);
}

QString ShrinkTool::name() const
{
    return tr("Shrink");
}

QString ShrinkTool::iconName() const
{
    return QStringLiteral("shrink-here");
}

QString ShrinkTool::hint() const
{
    return tr("Shrink: sketch over what grew too far; it goes, up to its narrowest passage, which "
              "is shut; what is nearer to the seeds stays");
}

QString ShrinkTool::target() const
{
    return tr("takes back what grew through here");
}

QString ShrinkTool::keys() const
{
    return tr("Ctrl: only the sketched voxels · %1").arg(SketchTool::keys());
}

void ShrinkTool::sketchBegan(const ViewContext& view)
{
    // The preview is said of a growth that stands; the edit would end it anyway.
    workspace().session()->closeGrowth();
    m_preview->begin(modifiers().testFlag(Qt::ControlModifier));
    m_sketched->begin(view);
}

void ShrinkTool::sketchGrew(const std::vector<glm::dvec2>& pixels)
{
    m_sketched->follow(pixels);
}

void ShrinkTool::sketchOver()
{
    m_sketched->end();
    m_preview->end();
}

QStringList ShrinkTool::cursorLines() const
{
    const QString cutPreview = m_preview->words();
    return cutPreview.isEmpty() ? QStringList{target()} : QStringList{cutPreview};
}

void ShrinkTool::commit(const std::vector<glm::ivec3>& voxels)
{
    core::ShrinkAt shrink;
    for (const glm::ivec3& voxel : voxels)
        shrink.pointsLps.push_back(workspace().volume()->geometry.toWorld(glm::dvec3(voxel)));
    shrink.onlyHere = modifiers().testFlag(Qt::ControlModifier);
    core::EditSession& session = *workspace().session();
    const std::size_t rows = session.history().rows().size();
    if (const auto applied = session.apply(shrink); !applied) {
        workspace().fail(applied.error());
        return;
    }
    // Answered when the edit is carried out.
    session.questions().afterAll([tool = QPointer<ShrinkTool>(this), rows] {
        if (!tool)
            return;
        // What was refused has been told already.
        const core::History& history = tool->workspace().session()->history();
        if (history.rows().size() > rows)
            tool->workspace().say(nameOf(history.rows().back()));
    });
}

QColor ShrinkTool::colour() const
{
    return theme::caution;
}

QString ShrinkTool::outsideText() const
{
    return tr("Nothing was taken back: the sketch lies outside the volume");
}

QString ShrinkTool::nothingSeenText() const
{
    return tr("Nothing was taken back: nothing is seen under the sketch");
}

} // namespace ui
