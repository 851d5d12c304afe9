// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/MeasureTool.h"

#include "core/edits/kinds/views/Measurements.h"
#include "core/measure/MeasureHandles.h"
#include "core/measure/MeasuredSize.h"
#include "ui/measure/MeasureTexts.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/SeenVoxels.h"
#include "ui/tools/view/MeasureOptions.h"
#include "ui/workspace/Workspace.h"

#include <QJsonObject>
#include <QPainter>
#include <QPointer>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

using Kind = core::Measurement::Kind;

/// A click is no measurement.
constexpr double leastPixels = 3.0;
/// So near to a point of a measurement a press takes hold of it.
constexpr double handlePixels = 6.0;
constexpr double samePlaneMm = 0.01;
constexpr const char* axesWord = "axes"; ///< in settings

double apart(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// Whether a picture of the view has no depth of its own, so that nothing tells how far away from
/// the viewer a place is.
bool isProjection(const ViewContext& view)
{
    if (const auto* slice = std::get_if<gpu::SliceScene>(&view.scene))
        return slice->slab.mode != gpu::SlabMode::Off;
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return scene && (scene->mode == gpu::RenderMode::Mip || scene->mode == gpu::RenderMode::Xray);
}

/// A curve of at most so many corners as an edit takes, evenly thinned out.
std::vector<glm::dvec3> thinned(const std::vector<glm::dvec3>& curve)
{
    const std::size_t step = (curve.size() - 1) / core::Annotate::mostCorners + 1;
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < curve.size(); i += step)
        corners.push_back(curve[i]);
    return corners;
}

} // namespace

MeasureTool::MeasureTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_axes(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &MeasureTool::cancel);
}

QString MeasureTool::name() const
{
    return tr("Measure");
}

QString MeasureTool::iconName() const
{
    return QStringLiteral("ruler");
}

QString MeasureTool::hint() const
{
    return tr("Measure (%1): %2")
        .arg(m_suggestsAxes ? tr("axes of a segment") : kindText(m_kind), howToDraw());
}

QString MeasureTool::keys() const
{
    return tr("Esc drops what is drawn");
}

QString MeasureTool::howToDraw() const
{
    if (m_suggestsAxes)
        return tr("click on a segment in a slice; its longest axis there and the longest one "
                  "across it are measured");
    switch (m_kind) {
    case Kind::Distance:
        return tr("drag from one place to the other");
    case Kind::Angle:
        return tr("drag along one side to the vertex, then click at the end of the other side");
    case Kind::Ellipse:
    case Kind::Rectangle:
        return tr("drag from corner to corner on a slice");
    case Kind::Outline:
        return tr("draw around the region on a slice; the outline closes by itself");
    case Kind::Ball:
        return tr("drag from the centre to the surface on a slice");
    case Kind::Probe:
        return tr("click at a place");
    case Kind::Arrow:
        return tr("drag from the tip to where the words stand");
    case Kind::Text:
        return tr("write in the bar above, then click at the place");
    }
    return {};
}

QWidget* MeasureTool::createOptions(QWidget* parent)
{
    return new MeasureOptions(m_workspace, *this, parent);
}

QJsonObject MeasureTool::settingsJson() const
{
    const char* word = m_suggestsAxes ? axesWord : core::measurementWords[std::size_t(m_kind)];
    return {{QStringLiteral("kind"), QLatin1String(word)}};
}

void MeasureTool::applySettings(const QJsonObject& settings)
{
    const QString word = settings[QLatin1String("kind")].toString();
    if (word == QLatin1String(axesWord))
        return suggestAxes();
    for (std::size_t kind = 0; kind < core::measurementWords.size(); ++kind) {
        if (word == QLatin1String(core::measurementWords[kind]))
            setKind(Kind(kind));
    }
}

void MeasureTool::setKind(Kind kind)
{
    if (kind == m_kind && !m_suggestsAxes)
        return;
    cancel();
    m_kind = kind;
    m_suggestsAxes = false;
    Q_EMIT kindChanged();
    Q_EMIT overlayChanged();
}

void MeasureTool::suggestAxes()
{
    setKind(Kind::Distance);
    m_suggestsAxes = true;
    Q_EMIT kindChanged();
}

void MeasureTool::setText(const QString& text)
{
    if (text == m_text)
        return;
    m_text = text;
    Q_EMIT textChanged();
}

bool MeasureTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    if (!scene)
        return true;
    const bool needsPlane = m_suggestsAxes || m_kind == Kind::Ellipse || m_kind == Kind::Rectangle
        || m_kind == Kind::Outline || m_kind == Kind::Ball;
    return scene->orthographic && !needsPlane;
}

bool MeasureTool::isSameView(const ViewContext& view) const
{
    if (view.view != m_view->view)
        return false;
    const auto* slice = std::get_if<gpu::SliceScene>(&view.scene);
    if (!slice) {
        // A place on the plane of the target is seen where it was.
        const auto isUnmoved = [&](const QPointF& pixel) {
            return glm::distance(view.toLps(pixel), m_view->toLps(pixel)) < samePlaneMm;
        };
        return isUnmoved({0.0, 0.0}) && isUnmoved({100.0, 50.0}) && isUnmoved({0.0, 100.0});
    }
    // A slice may be moved and zoomed, as long as it is the same.
    const auto& first = std::get<gpu::SliceScene>(m_view->scene);
    const glm::dvec3 normal = glm::cross(first.rightLps, first.downLps);
    return std::abs(glm::dot(normal, slice->centreLps - first.centreLps)) < samePlaneMm
        && std::abs(glm::dot(normal, slice->rightLps)) < 1e-5
        && std::abs(glm::dot(normal, slice->downLps)) < 1e-5;
}

void MeasureTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.volume() || !worksIn(view) || m_pressed)
        return;
    if (m_view && !isSameView(view)) {
        cancel();
        return m_workspace.say(tr("The view is another one: the angle was dropped"));
    }
    const glm::dvec3 place = view.toLps(sample.position);
    if (!m_view)
        m_held = heldAt(sample.position, view);
    if (m_held) {
        // It is taken hold of.
    } else if (m_view) {
        m_points.push_back(place); // the end of the other side
    } else {
        m_points = {place};
        if (!isClicked() && m_kind != Kind::Outline)
            m_points.push_back(place);
    }
    m_view = view;
    m_pressed = true;
    hover(sample, view);
}

std::optional<MeasureTool::Held> MeasureTool::heldAt(
    const QPointF& at, const ViewContext& view) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !view.isSlice() || isClicked())
        return std::nullopt;
    std::optional<Held> nearest;
    double nearestPixels = handlePixels;
    for (const core::Measurement& each : session->document().measurements) {
        if (!isShown(each, view, m_workspace))
            continue;
        for (std::size_t point = 0; point < each.pointsLps.size(); ++point) {
            const double pixels = apart(view.toPixel(each.pointsLps[point]), at);
            if (pixels > nearestPixels)
                continue;
            nearestPixels = pixels;
            nearest =
                Held{.measured = each, .point = point, .pressedLps = view.toLps(at), .moved = each};
        }
    }
    return nearest;
}

void MeasureTool::dragHeld(const QPointF& to)
{
    // As far beside the pointer, and beside the middle of the slice, as it was.
    const glm::dvec3 place =
        m_held->measured.pointsLps[m_held->point] + m_view->toLps(to) - m_held->pressedLps;
    m_held->moved.pointsLps = core::draggedPoints(m_held->measured, m_held->point, place);
}

void MeasureTool::letGo()
{
    const Held held = *m_held;
    cancel();
    if (held.moved == held.measured)
        return;
    const core::MoveMeasurement edit{
        .measurement = held.measured.id, .pointsLps = held.moved.pointsLps};
    if (const auto moved = m_workspace.session()->apply(edit); !moved)
        m_workspace.fail(moved.error());
}

void MeasureTool::moveLast(const PointerSample& sample)
{
    const glm::dvec3 place = m_view->toLps(sample.position);
    if (m_kind != Kind::Outline)
        m_points.back() = place;
    else if (apart(m_view->toPixel(m_points.back()), sample.position) >= leastPixels / 2.0)
        m_points.push_back(place);
}

void MeasureTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_pressed || view.view != m_view->view)
        return;
    if (m_held)
        dragHeld(sample.position);
    else
        moveLast(sample);
    hover(sample, view);
}

bool MeasureTool::isMeant() const
{
    if (isClicked())
        return true;
    const QPointF first = m_view->toPixel(m_points.front());
    const QPointF last = m_view->toPixel(m_points.back());
    switch (m_kind) {
    case Kind::Ellipse:
    case Kind::Rectangle:
        return std::abs(first.x() - last.x()) >= leastPixels
            && std::abs(first.y() - last.y()) >= leastPixels;
    case Kind::Outline: {
        QRectF box;
        for (const glm::dvec3& point : m_points)
            box |= QRectF(m_view->toPixel(point), QSizeF(1e-6, 1e-6));
        return m_points.size() >= 3 && box.width() >= leastPixels && box.height() >= leastPixels;
    }
    case Kind::Angle:
        if (m_points.size() == 3)
            return apart(m_view->toPixel(m_points[1]), last) >= leastPixels;
        break;
    case Kind::Distance:
    case Kind::Ball:
    case Kind::Probe:
    case Kind::Arrow:
    case Kind::Text:
        break;
    }
    return apart(first, last) >= leastPixels;
}

void MeasureTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_pressed)
        return;
    m_pressed = false;
    if (m_held)
        return letGo();
    if (!isMeant()) {
        cancel();
        return m_workspace.say(tr("Nothing was measured: %1").arg(howToDraw()));
    }
    if (m_kind == Kind::Angle && m_points.size() < 3) {
        Q_EMIT stepsChanged(); // the other side is still to come
        return Q_EMIT overlayChanged();
    }
    finish();
}

core::Measurement MeasureTool::drawn() const
{
    core::Measurement measured{.kind = m_kind, .pointsLps = m_points};
    measured.projected = isProjection(*m_view);
    if (isNote())
        measured.text = m_text.trimmed();
    if (m_kind == Kind::Outline)
        measured.pointsLps = thinned(m_points);
    if (m_kind != Kind::Ellipse && m_kind != Kind::Rectangle)
        return measured;
    // The box of a drag, along the picture.
    const auto& slice = std::get<gpu::SliceScene>(m_view->scene);
    const glm::dvec3 way = m_points[1] - m_points[0];
    const glm::dvec3 right = glm::dot(way, slice.rightLps) * slice.rightLps;
    const glm::dvec3 down = glm::dot(way, slice.downLps) * slice.downLps;
    if (m_kind == Kind::Rectangle) {
        measured.pointsLps = {m_points[0], m_points[0] + right, m_points[0] + down};
    } else {
        const glm::dvec3 centre = m_points[0] + (right + down) / 2.0;
        measured.pointsLps = {centre, centre + right / 2.0, centre + down / 2.0};
    }
    return measured;
}

void MeasureTool::finish()
{
    const core::Measurement measured = drawn();
    const ViewContext view = *m_view;
    cancel();
    if (m_suggestsAxes)
        return m_axes.suggest(view, measured.pointsLps.front());
    if (m_kind == Kind::Text && measured.text.isEmpty())
        return m_workspace.say(tr("Nothing was noted: %1").arg(howToDraw()));
    if (view.isSlice())
        keep(measured);
    else
        measureWhatIsSeen(measured, view);
}

void MeasureTool::measureWhatIsSeen(const core::Measurement& drawn, const ViewContext& view)
{
    std::vector<glm::dvec2> places;
    for (const glm::dvec3& point : drawn.pointsLps)
        places.push_back(view.toViewPlaneMm(view.toPixel(point)));
    askWhatIsPointedAt(m_workspace, std::get<gpu::VolumeScene>(view.scene), places,
        [tool = QPointer<MeasureTool>(this), drawn](const core::Result<SeenVoxels>& seen) {
            if (!tool)
                return;
            if (!seen)
                return tool->m_workspace.fail(seen.error());
            core::Measurement measured = drawn;
            measured.pointsLps.clear();
            const core::VolumeGeometry& geometry = tool->m_workspace.volume()->geometry;
            for (const std::optional<SeenVoxel>& each : *seen) {
                if (!each)
                    return tool->m_workspace.say(
                        tr("Nothing was measured: nothing is seen at one of the ends"));
                measured.pointsLps.push_back(geometry.toWorld(glm::dvec3(each->voxel)));
            }
            const int piece = seen->front()->piece;
            const bool onOne = std::all_of(seen->begin(), seen->end(),
                [piece](const auto& each) { return each->piece == piece; });
            measured.piece = onOne ? piece : 0;
            tool->keep(measured);
        });
}

void MeasureTool::keep(const core::Measurement& measured)
{
    std::optional<int> piece;
    if (measured.piece != 0)
        piece = measured.piece;
    std::optional<bool> projected;
    if (measured.projected)
        projected = true;
    std::optional<QString> text;
    if (!measured.text.isEmpty())
        text = measured.text;
    const core::Result<void> kept = measured.kind == Kind::Distance
        ? m_workspace.session()->apply(core::AddMeasurement{.fromLps = measured.pointsLps[0],
            .toLps = measured.pointsLps[1],
            .piece = piece,
            .projected = projected})
        : m_workspace.session()->apply(core::Annotate{.kind = measured.kind,
            .pointsLps = measured.pointsLps,
            .text = text,
            .piece = piece,
            .projected = projected});
    if (!kept)
        return m_workspace.fail(kept.error());
    const QStringList lines =
        sizeLines(measured, core::measuredSize(measured, *m_workspace.volume()));
    const QString said = lines.join(QStringLiteral(" · "));
    if (!said.isEmpty())
        m_workspace.say(measured.piece != 0 ? tr("%1, true length of the piece").arg(said) : said);
}

void MeasureTool::cancel()
{
    m_pressed = false;
    m_held.reset();
    if (!m_view)
        return;
    m_view.reset();
    m_points.clear();
    Q_EMIT stepsChanged();
    Q_EMIT overlayChanged();
}

bool MeasureTool::canTakeStepBack() const
{
    return m_view && !m_pressed;
}

void MeasureTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.volume() || !worksIn(view))
        return;
    if (m_held) {
        if (m_view->view == view.view)
            paintMeasurement(painter, view, drawingOf(m_held->moved, view),
                sizeLines(m_held->moved, core::measuredSize(m_held->moved, *m_workspace.volume())));
    } else if (!m_suggestsAxes && m_view && m_view->view == view.view && isSameView(view)) {
        core::Measurement measured = drawn();
        const bool halfAngle = m_kind == Kind::Angle && m_points.size() < 3;
        if (halfAngle && !m_pressed)
            measured.pointsLps.push_back(view.toLps(cursor()));
        if (measured.pointsLps.size() < 3 && (halfAngle || measured.kind == Kind::Outline)) {
            // As much as is there of it.
            QPolygonF line;
            for (const glm::dvec3& point : measured.pointsLps)
                line << view.toPixel(point);
            paintMeasurement(painter, view, {.lines = {line}}, {});
            return;
        }
        // What is seen at its ends in 3D is known once it is there.
        QStringList words;
        if (view.isSlice() && measured.kind != Kind::Outline)
            words = sizeLines(measured, core::measuredSize(measured, *m_workspace.volume()));
        paintMeasurement(painter, view, drawingOf(measured, view), words);
    } else if (isUnderPointer(view)) {
        QString does = tr("measures from here");
        if (heldAt(cursor(), view))
            does = tr("moves this");
        else if (m_suggestsAxes)
            does = tr("suggests axes");
        else if (isNote())
            does = tr("notes here");
        drawCursorLabel(painter, view.sizePixels, cursor(), 4.0, {does});
    }
}

} // namespace ui
