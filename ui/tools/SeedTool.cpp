// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/SeedTool.h"

#include "ui/PendingSeeds.h"
#include "ui/SegmentActions.h"
#include "ui/Workspace.h"
#include "ui/tools/CursorLabel.h"
#include "ui/tools/PickQuestion.h"
#include "ui/tools/SeedMarks.h"
#include "ui/tools/SeedOptions.h"
#include "ui/tools/SeenVoxels.h"

#include <QPainter>
#include <QPointer>

#include <algorithm>
#include <array>
#include <set>

namespace ui {

namespace {

/// Each voxel once, in the order of the sketch.
std::vector<glm::ivec3> unique(const std::vector<glm::ivec3>& voxels)
{
    std::set<std::array<int, 3>> seen;
    std::vector<glm::ivec3> result;
    for (const glm::ivec3& voxel : voxels) {
        if (seen.insert({voxel.x, voxel.y, voxel.z}).second)
            result.push_back(voxel);
    }
    return result;
}

/// Neighbouring points of a sketch lie at most half a voxel apart, so no voxel is stepped over.
double pathStepPixels(const core::Volume& volume, const ViewContext& view)
{
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    return 0.5 * std::min({spacing.x, spacing.y, spacing.z}) / view.mmPerPixel();
}

glm::dvec2 pixelOf(const PointerSample& sample)
{
    return {sample.position.x(), sample.position.y()};
}

} // namespace

SeedTool::SeedTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_strokeView.reset();
        m_path.clear();
        Q_EMIT overlayChanged();
    });
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
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(m_workspace.activeSegment());
    return segment ? tr("seeds for %1").arg(segment->name) : tr("seeds for a new segment");
}

QString SeedTool::keys() const
{
    return tr("Esc drops the sketch");
}

QWidget* SeedTool::createOptions(QWidget* parent)
{
    return new SeedOptions(m_workspace, tr("Seeds for"), parent);
}

bool SeedTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || scene->orthographic;
}

void SeedTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.volume() || !worksIn(view) || m_strokeView)
        return;
    if (sample.eraserEnd) {
        m_workspace.say(tr("The seed tool has no use for the eraser end; turn the pen"));
        return;
    }
    m_strokeView = view;
    m_path = {pixelOf(sample)};
    hover(sample, view);
}

void SeedTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView || view.view != m_strokeView->view)
        return;
    m_path.push_back(pixelOf(sample));
    hover(sample, view);
}

void SeedTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_strokeView)
        return;
    if (m_strokeView->isSlice())
        commitOnSlice();
    else
        askWhatIsSeen();
    m_strokeView.reset();
    m_path.clear();
    Q_EMIT overlayChanged();
}

void SeedTool::cancel()
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    m_path.clear();
    m_workspace.say(tr("The sketch was dropped"));
    Q_EMIT overlayChanged();
}

void SeedTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_cursorView = view.view;
    Q_EMIT overlayChanged();
}

void SeedTool::leave()
{
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void SeedTool::commitOnSlice()
{
    const core::Volume& volume = *m_workspace.volume();
    std::vector<glm::ivec3> voxels;
    for (const glm::dvec2& pixel : alongPath(m_path, pathStepPixels(volume, *m_strokeView))) {
        const glm::dvec3 lps = m_strokeView->toLps({pixel.x, pixel.y});
        const glm::ivec3 voxel(glm::round(volume.geometry.toIndex(lps)));
        if (volume.geometry.contains(voxel))
            voxels.push_back(voxel);
    }
    if (voxels.empty())
        m_workspace.say(tr("No seed was set: the sketch lies outside the volume"));
    else
        commit(unique(voxels));
}

void SeedTool::askWhatIsSeen()
{
    const core::Volume& volume = *m_workspace.volume();
    std::vector<glm::dvec2> planeMm;
    for (const glm::dvec2& pixel : alongPath(m_path, pathStepPixels(volume, *m_strokeView)))
        planeMm.push_back(m_strokeView->toViewPlaneMm({pixel.x, pixel.y}));
    const auto& scene = std::get<gpu::VolumeScene>(m_strokeView->scene);
    ui::askWhatIsSeen(m_workspace, scene, planeMm,
        [tool = QPointer<SeedTool>(this)](const core::Result<SeenVoxels>& seen) {
            if (!tool)
                return;
            if (!seen) {
                tool->m_workspace.fail(seen.error());
                return;
            }
            std::vector<glm::ivec3> voxels;
            for (const auto& pick : *seen) {
                if (pick)
                    voxels.push_back(pick->voxel);
            }
            if (voxels.empty())
                tool->m_workspace.say(tr("No seed was set: nothing is seen under the sketch"));
            else
                tool->commit(unique(voxels));
        });
}

void SeedTool::commit(const std::vector<glm::ivec3>& voxels)
{
    const core::Result<int> label = ensureActiveSegment(m_workspace);
    if (!label) {
        m_workspace.fail(label.error());
        return;
    }
    core::SeedStroke stroke;
    stroke.segment = *label;
    for (const glm::ivec3& voxel : voxels)
        stroke.pointsLps.push_back(m_workspace.volume()->geometry.toWorld(glm::dvec3(voxel)));
    if (const auto applied = m_workspace.session()->apply(stroke); !applied) {
        m_workspace.fail(applied.error());
        return;
    }
    const QString name = m_workspace.session()->foreseenDocument().segment(*label)->name;
    m_workspace.say(voxels.size() == 1 ? tr("One seed voxel for %1").arg(name)
                                       : tr("%1 seed voxels for %2").arg(voxels.size()).arg(name));
}

void SeedTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view))
        return;
    if (view.isSlice())
        paintSeedMarks(painter, view, m_workspace);

    const core::Segment* segment = session->document().segment(m_workspace.activeSegment());
    const QColor colour =
        segment ? QColor(segment->rgb) : QColor(nextSegmentColour(session->document()));
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_strokeView && m_strokeView->view == view.view) {
        QPolygonF line;
        for (const glm::dvec2& pixel : m_path)
            line.push_back({pixel.x, pixel.y});
        if (line.size() == 1)
            line.push_back(line.front());
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(0, 0, 0, 150), 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        painter.setPen(QPen(colour, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    if (m_cursorView != view.view)
        return;
    painter.setPen(QPen(QColor(0, 0, 0, 180), 1.0));
    painter.setBrush(colour);
    painter.drawEllipse(m_cursor, 4.0, 4.0);
    drawCursorLabel(painter, view.sizePixels, m_cursor, 4.0, {target()});
}

} // namespace ui
