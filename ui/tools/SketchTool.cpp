// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/SketchTool.h"

#include "ui/Workspace.h"
#include "ui/tools/CursorLabel.h"
#include "ui/tools/PickQuestion.h"
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

SketchTool::SketchTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_strokeView.reset();
        m_path.clear();
        Q_EMIT overlayChanged();
    });
}

QString SketchTool::keys() const
{
    return tr("Esc drops the sketch");
}

bool SketchTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || scene->orthographic;
}

void SketchTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.volume() || !worksIn(view) || m_strokeView)
        return;
    if (sample.eraserEnd && !takesEraser()) {
        m_workspace.say(tr("A sketch has no use for the eraser end; turn the pen"));
        return;
    }
    m_modifiers = sample.modifiers;
    m_withEraser = sample.eraserEnd;
    m_strokeView = view;
    m_path = {pixelOf(sample)};
    hover(sample, view);
}

void SketchTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView || view.view != m_strokeView->view)
        return;
    m_path.push_back(pixelOf(sample));
    hover(sample, view);
}

void SketchTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_strokeView)
        return;
    if (!finishOtherwise(m_path, *m_strokeView)) {
        if (m_strokeView->isSlice())
            commitOnSlice();
        else
            askWhatIsSeen();
    }
    m_strokeView.reset();
    m_path.clear();
    m_modifiers = {};
    m_withEraser = false;
    Q_EMIT overlayChanged();
}

void SketchTool::cancel()
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    m_path.clear();
    m_workspace.say(tr("The sketch was dropped"));
    Q_EMIT overlayChanged();
}

void SketchTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_cursorView = view.view;
    Q_EMIT overlayChanged();
}

void SketchTool::leave()
{
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void SketchTool::commitOnSlice()
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
        m_workspace.say(outsideText());
    else
        commit(unique(voxels));
}

void SketchTool::askWhatIsSeen()
{
    const core::Volume& volume = *m_workspace.volume();
    std::vector<glm::dvec2> planeMm;
    for (const glm::dvec2& pixel : alongPath(m_path, pathStepPixels(volume, *m_strokeView)))
        planeMm.push_back(m_strokeView->toViewPlaneMm({pixel.x, pixel.y}));
    const auto& scene = std::get<gpu::VolumeScene>(m_strokeView->scene);
    ui::askWhatIsSeen(m_workspace, scene, planeMm,
        [tool = QPointer<SketchTool>(this)](const core::Result<SeenVoxels>& seen) {
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
                tool->m_workspace.say(tool->nothingSeenText());
            else
                tool->commit(unique(voxels));
        });
}

void SketchTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !worksIn(view))
        return;
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
        painter.setPen(QPen(colour(), 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    if (m_cursorView != view.view)
        return;
    painter.setPen(QPen(QColor(0, 0, 0, 180), 1.0));
    painter.setBrush(colour());
    painter.drawEllipse(m_cursor, 4.0, 4.0);
    drawCursorLabel(painter, view.sizePixels, m_cursor, 4.0, {target()});
}

} // namespace ui
