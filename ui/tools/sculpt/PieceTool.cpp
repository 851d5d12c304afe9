// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/PieceTool.h"

#include "ui/base/Theme.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <array>
#include <cmath>
#include <numbers>

namespace ui {

namespace {

constexpr double handleRadius = 7.0;
constexpr double reachPixels = 12.0;
constexpr double degreesPerPixel = 0.6;
constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

struct Axes {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 towardsViewer;
};

Axes axesOf(const ViewContext& view)
{
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    const glm::dvec3 forward = glm::normalize(scene.targetLps - scene.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, scene.up));
    return {right, glm::cross(right, forward), -forward};
}

double distance(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

double angleOf(const QPointF& from)
{
    return std::atan2(-from.y(), from.x()) * degreesPerRadian;
}

} // namespace

PieceTool::PieceTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace.pieces(), &Pieces::looksChanged, this, &Tool::overlayChanged);
    connect(&workspace.pieces(), &Pieces::activeChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_drag.reset();
        m_hovered.reset();
    });
}

QString PieceTool::name() const
{
    return tr("Pieces");
}

QString PieceTool::iconName() const
{
    return QStringLiteral("piece");
}

QString PieceTool::hint() const
{
    const core::EditSession* session = m_workspace.session();
    return session && session->document().pieces.empty()
        ? tr("Pieces: none yet; Ctrl+L lifts the last cut of the active layer")
        : tr("Pieces: drag a middle to move it, the ring to turn it, a knob to tip it over");
}

QString PieceTool::keys() const
{
    return tr("Esc takes back · Ctrl+Shift+wheel zooms the piece · Ctrl+H all home");
}

bool PieceTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return m_workspace.volume() && scene && scene->orthographic;
}

QPointF PieceTool::middleOf(const core::Piece& piece, const ViewContext& view) const
{
    return view.toPixel(core::pivotOf(piece, m_workspace.volume()->geometry)
        + m_workspace.pieces().pose(piece).offsetMm);
}

std::optional<PieceTool::Handle> PieceTool::handleAt(
    const QPointF& pixel, const ViewContext& view) const
{
    std::optional<Handle> nearest;
    double apart = reachPixels;
    const auto consider = [&](const Handle& handle, double away) {
        if (away <= apart) {
            apart = away;
            nearest = handle;
        }
    };
    const Pieces& pieces = m_workspace.pieces();
    for (const core::Piece& piece : m_workspace.session()->document().pieces) {
        if (!pieces.look(piece.id).visible)
            continue;
        const QPointF middle = middleOf(piece, view);
        if (piece.id == pieces.active()) {
            consider({piece.id, Part::Ring, pixel},
                std::abs(distance(pixel, middle) - ringPixels) + 1.0);
            const QPointF right = middle + QPointF(ringPixels, 0);
            const QPointF up = middle - QPointF(0, ringPixels);
            consider({piece.id, Part::TipRight, right}, distance(pixel, right));
            consider({piece.id, Part::TipUp, up}, distance(pixel, up));
        }
        consider({piece.id, Part::Middle, middle}, distance(pixel, middle));
    }
    return nearest;
}

bool PieceTool::takes(const PointerSample& sample, const ViewContext& view) const
{
    return handleAt(sample.position, view).has_value();
}

void PieceTool::press(const PointerSample& sample, const ViewContext& view)
{
    const std::optional<Handle> handle = handleAt(sample.position, view);
    if (!handle)
        return;
    const core::Piece* piece = m_workspace.session()->document().piece(handle->piece);
    m_workspace.pieces().setActive(piece->id);
    m_drag = Drag{*handle, sample.position, middleOf(*piece, view), piece->pose};
    hover(sample, view);
}

core::PiecePose PieceTool::turned(
    const core::PiecePose& before, const glm::dvec3& axisLps, double degrees) const
{
    core::PiecePose pose = before;
    pose.rotationDegrees = core::rotationDegrees(
        core::rotationMatrix(axisLps * degrees) * core::rotationMatrix(before.rotationDegrees));
    return pose;
}

void PieceTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_drag)
        return;
    m_cursor = sample.position;
    const Axes axes = axesOf(view);
    const QPointF moved = sample.position - m_drag->from;
    core::PiecePose pose = m_drag->before;
    switch (m_drag->handle.part) {
    case Part::Middle:
        pose.offsetMm += (axes.right * moved.x() - axes.up * moved.y()) * view.mmPerPixel();
        break;
    case Part::Ring:
        pose = turned(pose, axes.towardsViewer,
            angleOf(sample.position - m_drag->middle) - angleOf(m_drag->from - m_drag->middle));
        break;
    case Part::TipRight:
        pose = turned(pose, axes.up, moved.x() * degreesPerPixel);
        break;
    case Part::TipUp:
        pose = turned(pose, axes.right, moved.y() * degreesPerPixel);
        break;
    }
    m_workspace.pieces().hold(m_drag->handle.piece, pose);
}

void PieceTool::release(const PointerSample& sample, const ViewContext& view)
{
    m_drag.reset();
    m_workspace.pieces().letGo();
    hover(sample, view);
}

void PieceTool::cancel()
{
    if (!m_drag)
        return;
    m_drag.reset();
    m_workspace.pieces().letGo(false);
}

void PieceTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_hovered = handleAt(sample.position, view);
    Q_EMIT overlayChanged();
}

void PieceTool::leave()
{
    m_hovered.reset();
    Q_EMIT overlayChanged();
}

void PieceTool::changeDepth(int steps)
{
    const core::EditSession* session = m_workspace.session();
    const core::Piece* piece =
        session ? session->document().piece(m_workspace.pieces().active()) : nullptr;
    if (!piece)
        return;
    core::PiecePose pose = piece->pose;
    pose.zoom = std::round(pose.zoom * std::pow(1.1, steps) * 100.0) / 100.0;
    m_workspace.pieces().setPose(piece->id, pose);
}

void PieceTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.volume() || view.isSlice())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const Pieces& pieces = m_workspace.pieces();
    const std::optional<Handle> marked = m_drag ? m_drag->handle : m_hovered;
    const auto knob = [&](const Handle& handle, double radius) {
        const bool lit = marked && *marked == handle;
        painter.setPen(QPen(QColor(0, 0, 0, 190), 1.6));
        painter.setBrush(lit ? theme::text : theme::accent);
        painter.drawEllipse(handle.pixel, lit ? radius + 1.5 : radius, lit ? radius + 1.5 : radius);
    };
    for (const core::Piece& piece : m_workspace.session()->document().pieces) {
        if (!pieces.look(piece.id).visible)
            continue;
        const QPointF middle = middleOf(piece, view);
        if (piece.id == pieces.active()) {
            const bool lit = marked && marked->piece == piece.id && marked->part == Part::Ring;
            painter.setBrush(Qt::NoBrush);
            for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 4.0),
                     QPen(lit ? theme::text : theme::accent, lit ? 2.4 : 1.6)}) {
                painter.setPen(pen);
                painter.drawEllipse(middle, ringPixels, ringPixels);
            }
            knob({piece.id, Part::TipRight, middle + QPointF(ringPixels, 0)}, handleRadius - 2.0);
            knob({piece.id, Part::TipUp, middle - QPointF(0, ringPixels)}, handleRadius - 2.0);
        }
        knob({piece.id, Part::Middle, middle}, handleRadius);
    }
    if (!marked)
        return;
    const core::Piece* piece = m_workspace.session()->document().piece(marked->piece);
    if (!piece)
        return;
    static const std::array<const char*, 4> words{
        QT_TR_NOOP("move"), QT_TR_NOOP("turn"), QT_TR_NOOP("tip over"), QT_TR_NOOP("tip over")};
    const QString badge = Pieces::badge(pieces.pose(*piece));
    drawCursorLabel(painter, view.sizePixels, m_cursor, handleRadius,
        {m_drag && !badge.isEmpty()
                ? badge
                : piece->name + QStringLiteral(": ") + tr(words[std::size_t(marked->part)])});
}

} // namespace ui
