// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/UndoHereTool.h"

#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/tasks/UndoOnly.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>
#include <QPointer>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double leastRadiusMm = 1.0;
constexpr double greatestRadiusMm = 50.0;
constexpr double leastDragPixels = 6.0;

} // namespace

UndoHereTool::UndoHereTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] { m_pressedView.reset(); });
}

QString UndoHereTool::name() const
{
    return tr("Revert");
}

QString UndoHereTool::iconName() const
{
    return QStringLiteral("undo-here");
}

QString UndoHereTool::hint() const
{
    return tr("Revert: click on what is to go, or drag a rectangle on a slice; the last step "
              "there is taken back, all others stay");
}

QString UndoHereTool::target() const
{
    return tr("undoes the last step here only");
}

QString UndoHereTool::keys() const
{
    return tr("[ ] radius · Esc cancels");
}

bool UndoHereTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || (scene->orthographic && scene->context != gpu::Context::Hidden);
}

void UndoHereTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.volume() || !worksIn(view) || m_pressedView)
        return;
    m_pressedView = view;
    m_pressed = sample.position;
    hover(sample, view);
}

void UndoHereTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (m_pressedView && view.view == m_pressedView->view)
        hover(sample, view);
}

void UndoHereTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_pressedView)
        return;
    if (m_pressedView->isSlice())
        undoOnSlice();
    else
        undoWhatIsSeen();
    m_pressedView.reset();
    Q_EMIT overlayChanged();
}

void UndoHereTool::cancel()
{
    m_pressedView.reset();
    Q_EMIT overlayChanged();
}

void UndoHereTool::changeRadius(int steps)
{
    m_radiusMm = std::clamp(m_radiusMm + steps, leastRadiusMm, greatestRadiusMm);
    Q_EMIT overlayChanged();
}

bool UndoHereTool::isRectangle() const
{
    const QPointF way = cursor() - m_pressed;
    return m_pressedView && m_pressedView->isSlice()
        && std::max(std::abs(way.x()), std::abs(way.y())) >= leastDragPixels;
}

void UndoHereTool::undoOnSlice()
{
    const ViewContext& view = *m_pressedView;
    const QPointF other = isRectangle() ? cursor() : m_pressed;
    std::vector<glm::dvec3> corners;
    for (const QPointF& corner :
        {m_pressed, other, QPointF(m_pressed.x(), other.y()), QPointF(other.x(), m_pressed.y())})
        corners.push_back(view.toLps(corner));
    if (!isRectangle()) {
        undoOnlyLast(m_workspace, {.box = boxAround(corners, m_radiusMm)}, tr("here"));
        return;
    }
    // In the plane the rectangle says how far; across it the radius does.
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 normal = glm::normalize(glm::cross(slice.rightLps, slice.downLps));
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        corners.push_back(corners[i] - m_radiusMm * normal);
        corners[i] += m_radiusMm * normal;
    }
    undoOnlyLast(m_workspace, {.box = boxAround(corners, 0.0)}, tr("in this box"));
}

void UndoHereTool::undoWhatIsSeen()
{
    const auto& scene = std::get<gpu::VolumeScene>(m_pressedView->scene);
    m_workspace.session()->questions().pick(
        pickQuestion(scene, {m_pressedView->toViewPlaneMm(m_pressed)}, *m_workspace.volume()),
        [tool = QPointer<UndoHereTool>(this)](const core::Result<PickedVoxels>& picked) {
            if (!tool || !tool->m_workspace.volume())
                return;
            if (!picked) {
                tool->m_workspace.fail(picked.error());
            } else if (picked->empty() || !picked->front()) {
                tool->m_workspace.say(tr("Nothing is seen there"));
            } else {
                const glm::dvec3 seen =
                    tool->m_workspace.volume()->geometry.toWorld(glm::dvec3(*picked->front()));
                undoOnlyLast(tool->m_workspace, {.box = tool->boxAround({seen}, tool->m_radiusMm)},
                    tr("here"));
            }
        });
}

core::VoxelBox UndoHereTool::boxAround(
    const std::vector<glm::dvec3>& pointsLps, double reachMm) const
{
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const glm::dvec3 reach = reachMm / geometry.spacingMm();
    glm::dvec3 low(1e9);
    glm::dvec3 high(-1e9);
    for (const glm::dvec3& point : pointsLps) {
        const glm::dvec3 index = geometry.toIndex(point);
        low = glm::min(low, index - reach);
        high = glm::max(high, index + reach);
    }
    const glm::dvec3 size(geometry.size);
    return {glm::ivec3(glm::clamp(glm::round(low), glm::dvec3(0.0), size)),
        glm::ivec3(glm::clamp(glm::round(high) + 1.0, glm::dvec3(0.0), size))};
}

void UndoHereTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const double radius = m_radiusMm / view.mmPerPixel();
    const bool rectangle = isRectangle() && m_pressedView->view == view.view;
    // A dark rim under the bright line, to be seen on bone and on black alike.
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 3.5), QPen(toolColour(), 1.6)}) {
        painter.setPen(pen);
        if (rectangle)
            painter.drawRect(QRectF(m_pressed, cursor()).normalized());
        else
            painter.drawEllipse(cursor(), radius, radius);
    }
    drawCursorLabel(painter, view.sizePixels, cursor(), rectangle ? 4.0 : radius,
        {target(), tr("within %1 mm").arg(numberText(m_radiusMm, 1))});
}

} // namespace ui
