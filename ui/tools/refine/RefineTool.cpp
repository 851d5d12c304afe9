// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/refine/RefineTool.h"

#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/measure/MeasuredSize.h"
#include "core/refine/mesh/ShownSurface.h"
#include "core/volume/ClipRegion.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/refine/RefineOptions.h"
#include "ui/tools/refine/TemplateContours.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

/// From where rays of the 3D view are cast: before all that there is.
constexpr double farMm = 5000.0;

glm::dvec3 forwardOf(const ViewContext& view)
{
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    return glm::normalize(scene.targetLps - scene.eyeLps);
}

/// What clipping leaves of the surface in the 3D view, in index space; empty: it hides nothing.
std::vector<core::HalfSpace> seenSides(
    const gpu::VolumeScene& scene, const core::VolumeGeometry& geometry)
{
    std::vector<core::HalfSpace> sides = core::halfSpaces(scene.clip, geometry);
    if (scene.surface) {
        core::ClipRegion own;
        own.planes[0] = scene.surface->clip;
        const std::vector<core::HalfSpace> more = core::halfSpaces(own, geometry);
        sides.insert(sides.end(), more.begin(), more.end());
    }
    return sides;
}

/// Whether a tool has an opposite, which Ctrl and the pen's eraser end choose. A drag goes either
/// way by itself; nothing undoes what smooths or follows edges.
bool hasOpposite(Refinement::Mode mode)
{
    switch (mode) {
    case Refinement::Mode::Mark:
    case Refinement::Mode::Sphere:
    case Refinement::Mode::Scrape:
    case Refinement::Mode::Template: // contours are rubbed out
        return true;
    case Refinement::Mode::Drag:
    case Refinement::Mode::Attract:
    case Refinement::Mode::Smooth:
        break;
    }
    return false;
}

/// The mirror image of a place in a slice about the surface next to it. A sphere there pushes the
/// other way.
glm::dvec3 beyondSurface(
    const core::SurfaceMirror& surface, const gpu::SliceScene& slice, const glm::dvec3& placeLps)
{
    const auto& near = surface.vertex(surface.nearestVertex(placeLps));
    const double heightMm = glm::dot(placeLps - near.positionLps, near.normalLps);
    const glm::dvec3 across = glm::normalize(glm::cross(slice.rightLps, slice.downLps));
    const glm::dvec3 inSlice = near.normalLps - glm::dot(near.normalLps, across) * across;
    const double length = glm::length(inSlice);
    // Where the surface nearly lies in the slice, its other side is not in it.
    constexpr double leastLength = 0.3;
    if (length < leastLength)
        return placeLps - 2.0 * heightMm * near.normalLps;
    return placeLps - 2.0 * heightMm / (length * length) * inSlice;
}

} // namespace

RefineTool::RefineTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
{
    connect(&workspace.refinement(), &Refinement::settingsChanged, this, &Tool::overlayChanged);
    connect(&workspace.refinement(), &Refinement::changed, this, &Tool::overlayChanged);
    // A stroke ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_stroke.reset();
        m_contour.reset();
        m_rubber.reset();
    });
    connect(&workspace.refinement(), &Refinement::contoursChanged, this, &Tool::overlayChanged);
}

QString RefineTool::name() const
{
    return tr("Refine");
}

QString RefineTool::iconName() const
{
    return QStringLiteral("refine");
}

QString RefineTool::hint() const
{
    return tr("Refine: mark what is wrong with the surface, then push, scrape, drag or smooth it");
}

QString RefineTool::target() const
{
    const std::optional<core::RefinedSurface> surface = m_workspace.refinement().surface();
    if (!surface)
        return tr("no surface yet: lay one in the panel Refine");
    const core::Segment* segment = m_workspace.session()->document().segment(surface->segment);
    const QString name = segment ? segment->name : QString();
    switch (m_workspace.refinement().settings().mode) {
    case Refinement::Mode::Mark:
        return tr("marks the surface of %1").arg(name);
    case Refinement::Mode::Sphere:
        return (m_inverted ? tr("pushes %1 from the other side") : tr("pushes %1")).arg(name);
    case Refinement::Mode::Scrape:
        return (m_inverted ? tr("fills %1 up to a plane") : tr("scrapes %1")).arg(name);
    case Refinement::Mode::Drag:
        return tr("drags a point of %1").arg(name);
    case Refinement::Mode::Attract:
        return tr("draws %1 to edges").arg(name);
    case Refinement::Mode::Template:
        return m_inverted ? tr("rubs contours out") : tr("draws how %1 ought to run").arg(name);
    case Refinement::Mode::Smooth:
        break;
    }
    return tr("smooths %1").arg(name);
}

QString RefineTool::keys() const
{
    switch (m_workspace.refinement().settings().mode) {
    case Refinement::Mode::Mark:
        return tr("[ ] radius · Ctrl unmarks · Esc cancels");
    case Refinement::Mode::Sphere:
        return tr("[ ] radius · Ctrl pushes the other way · Esc cancels");
    case Refinement::Mode::Template:
        return tr("Esc takes back · Ctrl rubs out · back to the start: closed");
    case Refinement::Mode::Scrape:
        return tr("[ ] radius · Ctrl fills · Esc cancels");
    case Refinement::Mode::Drag:
    case Refinement::Mode::Attract:
    case Refinement::Mode::Smooth:
        break;
    }
    return tr("[ ] radius · Esc cancels");
}

QWidget* RefineTool::createOptions(QWidget* parent)
{
    return new RefineOptions(m_workspace, parent);
}

bool RefineTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || scene->orthographic;
}

bool RefineTool::takes(const PointerSample&, const ViewContext& view) const
{
    return view.isSlice() || m_workspace.refinement().settings().mode != Refinement::Mode::Template;
}

bool RefineTool::isInverse(const PointerSample& sample) const
{
    const bool asked = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    return asked && hasOpposite(m_workspace.refinement().settings().mode);
}

std::optional<core::MeshHit> RefineTool::hitAt(
    const core::SurfaceMirror& surface, const ViewContext& view, const QPointF& pixel) const
{
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const glm::dvec3 forward = forwardOf(view);
    const glm::dvec3 from = view.toLps(pixel) - farMm * forward;
    const std::vector<core::HalfSpace> seen = seenSides(scene, geometry);
    if (seen.empty())
        return surface.hit(from, forward);
    const glm::dvec3 origin = geometry.toIndex(from);
    const glm::dvec3 perMm = geometry.toIndex(from + forward) - origin;
    const auto stretch = core::stretchInside({.from = 0.0, .to = 2.0 * farMm}, origin, perMm, seen);
    if (!stretch)
        return std::nullopt;
    // Where the near side is hidden, the far one is seen from within.
    std::optional<core::MeshHit> hit =
        surface.hit(from + stretch->from * forward, forward, core::FaceSides::Both);
    if (!hit || stretch->from + hit->distanceMm > stretch->to)
        return std::nullopt;
    hit->distanceMm += stretch->from;
    return hit;
}

std::optional<glm::dvec3> RefineTool::placeOf(Stroke& stroke, const PointerSample& sample) const
{
    const QPointF& pixel = sample.position;
    if (const auto* slice = std::get_if<gpu::SliceScene>(&stroke.view.scene)) {
        const glm::dvec3 place = stroke.view.toLps(pixel);
        const bool isBeyond = stroke.inverted && stroke.settings.mode == Refinement::Mode::Sphere;
        return isBeyond ? beyondSurface(stroke.surface, *slice, place) : place;
    }
    const glm::dvec3 forward = forwardOf(stroke.view);
    const glm::dvec3 onTarget = stroke.view.toLps(pixel);
    using Mode = Refinement::Mode;
    // What is dragged moves in the plane of the view; so does a scraper, which stays in its own.
    const bool stays = stroke.settings.mode == Mode::Drag || stroke.settings.mode == Mode::Scrape;
    if (stays && stroke.depthMm != 0.0)
        return onTarget + (stroke.depthMm - farMm) * forward;
    const std::optional<core::MeshHit> hit = hitAt(stroke.surface, stroke.view, pixel);
    if (!hit)
        return std::nullopt;
    stroke.depthMm = hit->distanceMm;
    if (stroke.settings.mode != Mode::Sphere)
        return hit->placeLps;
    // Of the sphere as it is pressed: a smaller one that far out would touch nothing.
    const double share = stroke.isPressed ? pressedShare(sample) : 1.0;
    const double off = 0.5 * stroke.settings.radiusMm * share;
    return hit->placeLps + (stroke.inverted ? -off : off) * hit->normalLps;
}

core::Edit RefineTool::editOf(const Stroke& stroke, const glm::dvec3& placeLps) const
{
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    core::SurfacePath path{.radiusMm = stroke.settings.radiusMm,
        .pointsLps = {core::truePlace(geometry, placeLps)},
        .rules = core::newestSurfaceRules};
    if (stroke.isPressed)
        path.pressures = std::vector<double>{stroke.lastPressure};
    switch (stroke.settings.mode) {
    case Refinement::Mode::Mark:
        return core::MarkSurface{
            .mark = stroke.inverted ? core::SurfaceMark::Yellow : stroke.settings.mark,
            .path = path};
    case Refinement::Mode::Sphere:
        return core::SpherePush{.path = path};
    case Refinement::Mode::Scrape: {
        const auto& near = stroke.surface.vertex(stroke.surface.nearestVertex(placeLps));
        glm::dvec3 normal = core::trueNormal(geometry, near.positionLps, near.normalLps);
        std::optional<glm::dvec3> across;
        if (const auto* slice = std::get_if<gpu::SliceScene>(&stroke.view.scene)) {
            across =
                core::trueNormal(geometry, placeLps, glm::cross(slice->rightLps, slice->downLps));
            normal -= glm::dot(normal, *across) * *across;
        }
        const double length = glm::length(normal);
        normal = length > 0.0 ? normal / length : glm::dvec3(0.0, 0.0, 1.0);
        // From the other side: what lies below the plane is drawn up to it.
        return core::PlaneScrape{
            .path = path, .normalLps = stroke.inverted ? -normal : normal, .acrossLps = across};
    }
    case Refinement::Mode::Drag:
        return core::PointDrag{.path = path};
    case Refinement::Mode::Attract:
        return core::AttractSurface{.path = path};
    case Refinement::Mode::Smooth:
    case Refinement::Mode::Template: // no stroke of it is an edit
        break;
    }
    return core::SmoothSurface{.path = path};
}

void RefineTool::press(const PointerSample& sample, const ViewContext& view)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view) || m_stroke || m_contour || m_rubber)
        return;
    Refinement& refinement = m_workspace.refinement();
    if (!refinement.surface() || refinement.mirror().empty())
        return m_workspace.say(
            tr("There is no surface yet: lay one around a segment in the panel Refine"));
    if (refinement.settings().mode == Refinement::Mode::Template && isInverse(sample)) {
        m_rubber = Rubber{.view = view, .at = sample.position};
        rub(sample.position);
        return hover(sample, view);
    }
    if (refinement.settings().mode == Refinement::Mode::Template) {
        m_contour = Contour{.view = view, .pointsLps = {view.toLps(sample.position)}};
        return hover(sample, view);
    }
    refinement.dropPreview();
    m_stroke = Stroke{.view = view,
        .surface = refinement.mirror(),
        .settings = refinement.settings(),
        .inverted = isInverse(sample),
        .isPressed = refinement.settings().radiusByPressure && sample.isPen,
        .lastPressure = pressedShare(sample)};
    const std::optional<glm::dvec3> place = placeOf(*m_stroke, sample);
    if (!place) {
        m_stroke.reset();
        return m_workspace.say(tr("The surface is not there"));
    }
    m_stroke->last = *place;
    if (const auto begun = session->begin(editOf(*m_stroke, *place)); !begun) {
        m_stroke.reset();
        m_workspace.fail(begun.error());
    }
    hover(sample, view);
}

void RefineTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (m_rubber && view.view == m_rubber->view.view) {
        rub(sample.position);
        return hover(sample, view);
    }
    if (m_contour && view.view == m_contour->view.view) {
        m_contour->pointsLps.push_back(m_contour->view.toLps(sample.position));
        return hover(sample, view);
    }
    if (!m_stroke || view.view != m_stroke->view.view)
        return;
    const std::optional<glm::dvec3> place = placeOf(*m_stroke, sample);
    const double pressure = pressedShare(sample);
    const bool widens = m_stroke->isPressed && pressesHarder(pressure, m_stroke->lastPressure);
    if (place && (*place != m_stroke->last || widens)) {
        const glm::dvec3 truth = core::truePlace(m_workspace.volume()->geometry, *place);
        m_workspace.session()->extend(core::PathPoints{.pointsLps = {truth},
            .pressures =
                m_stroke->isPressed ? std::vector<double>{pressure} : std::vector<double>()});
        m_stroke->last = *place;
        m_stroke->lastPressure = pressure;
    }
    hover(sample, view);
}

void RefineTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (m_rubber) {
        if (!std::exchange(m_rubber, std::nullopt)->hasMet)
            m_workspace.say(tr("No contour of this slice was there to rub out"));
        return hover(sample, view);
    }
    if (m_contour) {
        endContour();
        return hover(sample, view);
    }
    if (!m_stroke)
        return;
    m_stroke.reset();
    m_workspace.session()->end(core::Ending::Commit);
    hover(sample, view);
}

void RefineTool::endContour()
{
    const double pixelMm = m_contour->view.mmPerPixel();
    const auto drawn = drawnContour(std::move(m_contour->pointsLps), pixelMm);
    m_contour.reset();
    if (drawn)
        m_workspace.refinement().addContour(*drawn);
}

void RefineTool::rub(const QPointF& to)
{
    Refinement& refinement = m_workspace.refinement();
    for (std::size_t i = refinement.contours().size(); i-- > 0;) {
        if (!isRubbed(refinement.contours()[i], m_rubber->view, m_rubber->at, to))
            continue;
        refinement.removeContourAt(i);
        m_rubber->hasMet = true;
    }
    m_rubber->at = to;
}

void RefineTool::putAway()
{
    cancel();
    m_workspace.refinement().dropPreview();
}

void RefineTool::cancel()
{
    m_rubber.reset(); // what is rubbed out stays out
    if (m_contour) {
        m_contour.reset();
        return Q_EMIT overlayChanged();
    }
    // Esc once more: what is only looked at goes first, then what was drawn.
    if (!m_stroke && m_workspace.refinement().isPreviewing())
        return m_workspace.refinement().dropPreview();
    if (!m_stroke)
        return;
    m_stroke.reset();
    if (core::EditSession* session = m_workspace.session())
        session->end(core::Ending::Rollback);
    m_workspace.say(tr("The stroke was taken back"));
    Q_EMIT overlayChanged();
}

void RefineTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_pressure = m_stroke && m_stroke->isPressed ? pressedShare(sample) : 1.0;
    m_inverted = m_stroke ? m_stroke->inverted : m_rubber || isInverse(sample);
    showCursor(sample.position, view.view);
}

void RefineTool::changeRadius(int steps)
{
    Refinement::Settings settings = m_workspace.refinement().settings();
    const double step = settings.radiusMm < 10.0 ? 0.5 : settings.radiusMm < 30.0 ? 1.0 : 2.0;
    settings.radiusMm = std::clamp(std::round((settings.radiusMm + steps * step) / step) * step,
        minimumRadiusMm, maximumRadiusMm);
    m_workspace.refinement().setSettings(settings);
}

QColor RefineTool::colour() const
{
    const Refinement::Settings& settings = m_workspace.refinement().settings();
    if (settings.mode != Refinement::Mode::Mark)
        return toolColour();
    const gpu::SurfaceColours colours;
    const auto mark = m_inverted ? core::SurfaceMark::Yellow : settings.mark;
    return QColor(QRgb(colours.markRgb[std::size_t(mark)]));
}

void RefineTool::paintContours(QPainter& painter, const ViewContext& view) const
{
    const bool rubs = isRubber() && isUnderPointer(view);
    for (const auto& contour : m_workspace.refinement().contours()) {
        const bool goes = rubs && isRubbed(contour, view, cursor(), cursor());
        paintContour(painter, contour, view, goes ? theme::caution : toolColour());
    }
    if (m_contour)
        paintContour(painter, m_contour->pointsLps, view, toolColour());
    if (!rubs || !view.isSlice())
        return;
    drawCursorRing(painter, cursor(), rubberPixels, theme::caution, true);
    drawCursorLabel(painter, view.sizePixels, cursor(), rubberPixels, {target()});
}

void RefineTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (m_workspace.session())
        paintContours(painter, view);
    if (m_workspace.refinement().settings().mode == Refinement::Mode::Template)
        return;
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    const double radiusMm = m_workspace.refinement().settings().radiusMm;
    const double radius = m_pressure * radiusMm / view.mmPerPixel();
    drawCursorRing(painter, cursor(), radius, colour(), m_inverted);
    drawCursorLabel(painter, view.sizePixels, cursor(), radius,
        {target(), tr("radius %1 mm").arg(numberText(radiusMm, 1))});
}

} // namespace ui
