// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceWork.h"

#include "core/brick/LabelRuns.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/refine/deform/FollowBoundary.h"
#include "core/refine/fit/CrossingParts.h"
#include "core/refine/fit/MeasuredFit.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/tools/TemplateShape.h"
#include "core/refine/voxels/GreyBox.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/surface/SurfaceWriteBack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace core {

namespace {

/// From all of one mesh to all of another; a piece that comes out as it was is no part of it.
SimplexMeshDelta replacement(const SimplexMesh& before, const SimplexMesh& after)
{
    SimplexMeshDelta delta;
    for (VertexId id = 0; id < std::max(before.vertexSlots(), after.vertexSlots()); ++id) {
        const bool was = before.hasVertex(id);
        const bool is = after.hasVertex(id);
        const bool stayed = was && is && identical(before.vertex(id), after.vertex(id));
        if ((was || is) && !stayed)
            delta.vertices.push_back({.id = id,
                .before = was ? std::optional(before.vertex(id)) : std::nullopt,
                .after = is ? std::optional(after.vertex(id)) : std::nullopt});
    }
    for (FaceId id = 0; id < std::max(before.faceSlots(), after.faceSlots()); ++id) {
        const bool was = before.hasFace(id);
        const bool is = after.hasFace(id);
        const bool stayed = was && is && before.ring(id) == after.ring(id);
        if ((was || is) && !stayed)
            delta.faces.push_back({.id = id,
                .before = was ? before.ring(id) : FaceRing(),
                .after = is ? after.ring(id) : FaceRing()});
    }
    return delta;
}

std::vector<TemplateContour> contoursOf(const ApplyTemplate& shape)
{
    std::vector<TemplateContour> contours;
    for (const std::vector<glm::dvec3>& points : shape.contoursLps) {
        TemplateContour contour{.pointsLps = points, .isClosed = points.front() == points.back()};
        if (contour.isClosed)
            contour.pointsLps.pop_back();
        contours.push_back(std::move(contour));
    }
    return contours;
}

/// In how many of the mask's voxels a surface is off: "0.74 % off". What is not nothing is not told
/// as nothing.
RowTitle offTitle(const MeasuredFit& fit)
{
    constexpr double least = 0.01;
    const double percent = 100.0 * double(fit.voxelsOff) / double(fit.voxels);
    return {.code = RowTitleCode::PercentOff,
        .arguments = {fit.voxelsOff == 0
                ? TitleDecimal{.value = 0.0, .decimals = 0}
                : TitleDecimal{.value = std::max(percent, least), .decimals = 2}}};
}

/// How far an edge is looked for, times the tool's radius.
constexpr double attractReach = 0.5;

/// The tool of each kind of edit of the surface; none: it is no stroke.
struct Tools {
    const GreyBox* grey;

    std::optional<SurfaceTool> operator()(const MarkSurface& mark) const
    {
        return MarkBrush{.mark = mark.mark, .radiusMm = mark.path.radiusMm};
    }
    std::optional<SurfaceTool> operator()(const SpherePush& push) const
    {
        return SphereTool{.radiusMm = push.path.radiusMm};
    }
    std::optional<SurfaceTool> operator()(const PlaneScrape& scrape) const
    {
        return PlaneTool{.normalLps = scrape.normalLps,
            .radiusMm = scrape.path.radiusMm,
            .heightMm = 2.0 * scrape.path.radiusMm,
            .acrossLps = scrape.acrossLps.value_or(glm::dvec3(0.0))};
    }
    std::optional<SurfaceTool> operator()(const PointDrag& drag) const
    {
        return DragTool{.radiusMm = drag.path.radiusMm};
    }
    std::optional<SurfaceTool> operator()(const ApplyTemplate& shape) const
    {
        return TemplateTool{.contours = contoursOf(shape)};
    }
    std::optional<SurfaceTool> operator()(const SmoothSurface& smooth) const
    {
        return SmoothTool{.radiusMm = smooth.path.radiusMm};
    }
    std::optional<SurfaceTool> operator()(const AttractSurface& attract) const
    {
        return AttractTool{.radiusMm = attract.path.radiusMm,
            .reachMm = attractReach * attract.path.radiusMm,
            .grey = grey};
    }
    template <class E>
    requires isOneOf<E, LaySurface, DropSurface, FollowMask, ChangeMarks, WriteBack, SurfaceBarrier>
        std::optional<SurfaceTool>
    operator()(const E&) const { return std::nullopt; }
};

/// Whether the tool of an edit keeps the surface from passing through itself.
struct KeepsApart {
    bool operator()(const ApplyTemplate& shape) const { return keepsApart(shape.rules); }
    template <class Stroke>
    requires requires(const Stroke& stroke) { stroke.path; }
    bool operator()(const Stroke& stroke) const { return keepsApart(stroke.path.rules); }
    template <class E>
    requires isOneOf<E, LaySurface, DropSurface, FollowMask, ChangeMarks, WriteBack, SurfaceBarrier>
    bool operator()(const E&) const { return false; }
};

/// Whether an edit reads the labels of its segment's plane.
struct ReadsLabels {
    template <class E>
    requires isOneOf<E, LaySurface, FollowMask, WriteBack>
    bool operator()(const E&) const { return true; }
    template <class E>
    requires isOneOf<E, DropSurface, MarkSurface, ChangeMarks, SpherePush, PlaneScrape, PointDrag,
        ApplyTemplate, SmoothSurface, AttractSurface, SurfaceBarrier>
    bool operator()(const E&) const { return false; }
};

/// Whether an edit fits all of the surface to a mask.
struct FitsWhole {
    template <class E>
    requires isOneOf<E, LaySurface, FollowMask>
    bool operator()(const E&) const { return true; }
    template <class E>
    requires isOneOf<E, DropSurface, MarkSurface, ChangeMarks, SpherePush, PlaneScrape, PointDrag,
        ApplyTemplate, SmoothSurface, AttractSurface, WriteBack, SurfaceBarrier>
    bool operator()(const E&) const { return false; }
};

/// @param pairs of faces
tl::unexpected<Error> crosses(std::size_t pairs)
{
    return failure(ErrorCode::InvalidField, QLatin1String(crossingSurface), QString::number(pairs));
}

} // namespace

bool readsLabels(const Edit& edit)
{
    bool reads = false;
    visitAmong([&reads](const auto& known) { reads = ReadsLabels()(known); }, edit, SurfaceKinds());
    return reads;
}

bool fitsWholeSurface(const Edit& edit)
{
    bool fits = false;
    visitAmong([&fits](const auto& known) { fits = FitsWhole()(known); }, edit, SurfaceKinds());
    return fits;
}

std::optional<VoxelBox> greyBoxOf(const Edit& edit, const SurfaceState& surface)
{
    const auto* attract = edit.as<AttractSurface>();
    if (!attract)
        return std::nullopt;
    // A path may come anywhere on the surface, and is not known while the pen is down.
    const WorldToIndex toIndex(surface.geometry());
    const glm::dvec3 spacing = surface.geometry().spacingMm();
    const double reachMm = (1.0 + attractReach) * attract->path.radiusMm;
    glm::dvec3 least(std::numeric_limits<double>::max());
    glm::dvec3 most(std::numeric_limits<double>::lowest());
    for (const VertexId id : surface.mesh.vertexIds()) {
        const glm::dvec3 index = toIndex(surface.mesh.position(id));
        least = glm::min(least, index);
        most = glm::max(most, index);
    }
    VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const double margin = reachMm / spacing[axis] + 1.0;
        const int end = surface.geometry().size[axis];
        box.minimum[axis] = std::clamp(int(std::floor(least[axis] - margin)), 0, end - 1);
        box.maximum[axis] =
            std::clamp(int(std::ceil(most[axis] + margin)) + 1, box.minimum[axis] + 1, end);
    }
    return box;
}

SurfaceWork::SurfaceWork(
    SurfaceState& surface, SurfaceEdit edit, const Document& document, Read read)
    : m_surface(surface)
    , m_edit(std::move(edit))
    , m_read(std::move(read))
{
    const auto* lay = std::get_if<LaySurface>(&m_edit);
    m_segment = *document.segment(lay ? lay->segment : document.surface->segment);
    if (const auto* write = std::get_if<WriteBack>(&m_edit)) {
        if (write->overwriteUnlocked)
            m_overwritable = document.unlockedLabels(m_segment.plane);
        // A range that is not valid was refused by check().
        if (auto editable = editableVoxels(write->editable, document, "writeBack"))
            m_editable = *std::move(editable);
    }
    m_locked = document.lockedLabels(m_segment.plane);
}

SurfaceWork::~SurfaceWork() = default;

Result<void> SurfaceWork::begin()
{
    if (!m_read.codes.empty())
        m_grey = std::make_unique<const GreyBox>(m_surface.geometry(), m_read.greyBox.minimum,
            m_read.greyBox.maximum - m_read.greyBox.minimum, std::move(m_read.codes));
    std::optional<SurfaceTool> chosen = std::visit(Tools{m_grey.get()}, m_edit);
    if (!chosen)
        return {};
    if (auto* shape = std::get_if<TemplateTool>(&*chosen)) {
        const auto* edit = std::get_if<ApplyTemplate>(&m_edit);
        Result<TemplateShape> made = TemplateShape::make(m_surface.mesh, shape->contours,
            m_surface.target->faceAreaMm2(),
            mixesContours(edit->rules) ? TemplateForm::Body : TemplateForm::OfBefore, &m_progress);
        if (!made) {
            m_error = made.error();
            return tl::unexpected(*m_error);
        }
        shape->shape = std::make_shared<const TemplateShape>(*std::move(made));
    }
    m_stroke =
        std::make_unique<SurfaceStroke>(m_surface.mesh, &m_surface.target->boundary(), *chosen,
            SurfaceStrokeSettings{.areaMm2 = m_surface.target->faceAreaMm2(),
                .reddens = true,
                .apartOn = std::visit(KeepsApart(), m_edit) ? &m_surface.geometry() : nullptr,
                .progress = &m_progress});
    if (std::holds_alternative<TemplateTool>(*chosen)) {
        m_stroke->add({}); // it has no way of the pen, but begins with a sample as all do
        settle();
        if (m_progress.cancelled()) {
            m_error = {ErrorCode::Cancelled, {}};
            return tl::unexpected(*m_error);
        }
    }
    return {};
}

void SurfaceWork::settle()
{
    if (!m_settled) {
        m_stroke->settle();
        m_surface.show(updateOf(m_surface.mesh, m_stroke->takeWritten()));
    }
    m_settled = true;
}

void SurfaceWork::add(
    const std::vector<glm::dvec3>& pointsLps, const std::vector<double>& pressures)
{
    if (!m_stroke || m_error || pointsLps.empty())
        return;
    for (std::size_t i = 0; i < pointsLps.size(); ++i)
        m_stroke->add(
            {.placeLps = pointsLps[i], .pressure = i < pressures.size() ? pressures[i] : 1.0});
    m_surface.show(updateOf(m_surface.mesh, m_stroke->takeWritten()));
}

Result<SurfaceWork::Outcome> SurfaceWork::end(Ending ending)
{
    if (m_error) {
        if (m_stroke) {
            m_stroke->rollback();
            m_surface.showAll(true);
        }
        return tl::unexpected(*m_error);
    }
    return std::visit([&](const auto& edit) { return carryOut(edit, ending); }, m_edit);
}

template <class Stroke>
requires isOneOf<Stroke, MarkSurface, SpherePush, PlaneScrape, PointDrag, ApplyTemplate,
    SmoothSurface, AttractSurface>
    Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const Stroke&, Ending ending)
{
    if (ending == Ending::Rollback) {
        m_stroke->rollback();
        m_surface.showAll(true);
        return Outcome();
    }
    settle();
    // It may have been cancelled since the template stood.
    if (m_progress.cancelled()) {
        m_stroke->rollback();
        m_surface.showAll(true);
        return failure(ErrorCode::Cancelled);
    }
    SimplexMeshDelta delta = m_stroke->commit();
    if (delta.empty())
        return Outcome();
    return stepOf(std::move(delta));
}

Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const DropSurface&, Ending)
{
    return stepOf({});
}

SurfaceWork::Outcome SurfaceWork::stepOf(
    SimplexMeshDelta delta, std::optional<SurfaceStep::TargetChange> target)
{
    auto step = std::make_shared<SurfaceStep>();
    step->mesh = std::move(delta);
    step->target = std::move(target);
    step->sha256Before = m_surface.sha256;
    step->sha256After = step->mesh.empty() ? m_surface.sha256 : sha256Of(m_surface.mesh);
    if (step->target)
        m_surface.target = std::make_shared<const SurfaceTarget>(
            step->target->after.voxels, m_surface.geometry(), step->target->after.faceAreaMm2);
    m_surface.sha256 = step->sha256After;
    return {.step = std::move(step), .voxels = {}};
}

Result<SurfaceWork::Outcome> SurfaceWork::layCrossings()
{
    SimplexMeshEdit writing(m_surface.mesh);
    const Result<LaidAnew> laid = layCrossingsAnew(writing, m_surface.geometry(), m_progress);
    if (!laid)
        return tl::unexpected(laid.error());
    if (laid->left > 0)
        return crosses(laid->left);
    SimplexMeshDelta delta = writing.commit();
    if (delta.empty())
        return Outcome();
    m_surface.showAll(true);
    return stepOf(std::move(delta));
}

Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const LaySurface& edit, Ending)
{
    if (!beginsSurface(edit))
        return layCrossings();
    VoxelRuns voxels = labelRuns(m_labels, m_segment.label);
    if (voxels.empty())
        return failure(ErrorCode::InvalidField, QStringLiteral("surface.segment"),
            Clause::saying("'%1' has no voxels", m_segment.name));
    Result<MeasuredFit> fit = measuredFit(voxels, m_surface.geometry(),
        edit.vertices == 0 ? std::nullopt : std::optional(edit.vertices), m_progress,
        {.keepsApart = keepsApart(edit.rules),
            .mostVertices = laysFiner(edit.rules) ? mostVertices : mostVerticesOnce});
    if (!fit)
        return tl::unexpected(fit.error());
    if (fit->crossings > 0)
        return crosses(fit->crossings);
    SimplexMeshDelta delta = replacement(m_surface.mesh, fit->mesh);
    m_surface.mesh = std::move(fit->mesh);
    m_surface.showAll(true);
    const double faceAreaMm2 = meanFaceAreaMm2(m_surface.mesh);
    Outcome outcome = stepOf(std::move(delta),
        SurfaceStep::TargetChange{.before = m_surface.followed(),
            .after = {.voxels = std::move(voxels), .faceAreaMm2 = faceAreaMm2}});
    outcome.remark = offTitle(*fit);
    return outcome;
}

Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const FollowMask& edit, Ending)
{
    VoxelRuns voxels = labelRuns(m_labels, m_segment.label);
    if (voxels.empty())
        return failure(ErrorCode::InvalidField, QStringLiteral("followMask"),
            Clause::saying("'%1' has no voxels any more", m_segment.name));
    if (voxels == m_surface.target->voxels())
        return Outcome();
    SurfaceStep::TargetChange target{.before = m_surface.followed(),
        .after = {.voxels = std::move(voxels), .faceAreaMm2 = m_surface.target->faceAreaMm2()}};
    const SurfaceTarget next(target.after.voxels, m_surface.geometry(), target.after.faceAreaMm2);
    SimplexMeshEdit writing(m_surface.mesh);
    const Result<void> followed = followBoundary(writing, next.boundary(), m_progress,
        keepsApart(edit.rules) ? &m_surface.geometry() : nullptr);
    if (!followed) {
        writing.rollback();
        m_surface.showAll(true);
        return tl::unexpected(followed.error());
    }
    m_surface.show(updateOf(m_surface.mesh, writing.takeWritten()));
    return stepOf(writing.commit(), std::move(target));
}

std::vector<VertexId> SurfaceWork::markedVertices(const ChangeMarks& edit) const
{
    const SimplexMesh& mesh = m_surface.mesh;
    const auto isMarked = [&](VertexId id) { return mesh.mark(id) == edit.mark; };
    if (edit.nearLps) {
        const VertexId nearest = nearestVertex(mesh, *edit.nearLps, isMarked);
        return nearest == noId ? std::vector<VertexId>() : markedAround(mesh, nearest);
    }
    std::vector<VertexId> marked;
    for (const VertexId id : mesh.vertexIds()) {
        if (isMarked(id))
            marked.push_back(id);
    }
    return marked;
}

Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const ChangeMarks& edit, Ending)
{
    SimplexMeshEdit writing(m_surface.mesh);
    switch (edit.way) {
    case ChangeMarks::Way::Grow:
        growMarks(writing, edit.mark);
        break;
    case ChangeMarks::Way::Shrink:
        shrinkMarks(writing, edit.mark);
        break;
    case ChangeMarks::Way::Invert:
        exchangeMarks(writing, edit.mark, SurfaceMark::Yellow);
        break;
    case ChangeMarks::Way::Clear:
        for (const VertexId id : markedVertices(edit))
            writing.setMark(id, SurfaceMark::Yellow);
        break;
    case ChangeMarks::Way::Accept:
        for (const VertexId id : markedVertices(edit))
            writing.setMark(id, SurfaceMark::Green);
        break;
    }
    m_surface.show(updateOf(m_surface.mesh, writing.takeWritten()));
    SimplexMeshDelta delta = writing.commit();
    if (delta.empty())
        return Outcome();
    return stepOf(std::move(delta));
}

Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const WriteBack& edit, Ending)
{
    if (keepsApart(edit.rules)) {
        const std::size_t pairs = selfIntersections(m_surface.mesh, m_surface.geometry()).size();
        if (pairs > 0)
            return crosses(pairs);
    }
    const Result<EnclosedVoxels> enclosed =
        enclosedVoxels(m_surface.mesh, m_read.past, m_surface.geometry(), m_overwritable.any());
    if (!enclosed)
        return tl::unexpected(enclosed.error());
    RelabelListed voxels = writeBackOf(*enclosed, m_labels, m_surface.geometry().size,
        {.plane = m_segment.plane, .label = m_segment.label, .overwritable = m_overwritable});
    voxels.editable = m_editable;
    return Outcome{.step = nullptr, .voxels = std::move(voxels)};
}

Result<SurfaceWork::Outcome> SurfaceWork::carryOut(const SurfaceBarrier& edit, Ending)
{
    const Result<VoxelRuns> inside = voxelsOf(m_surface.mesh, m_surface.geometry(), {});
    if (!inside)
        return tl::unexpected(inside.error());
    const glm::ivec3& size = m_surface.geometry().size;
    return Outcome{.step = nullptr,
        .voxels = BarrierListed{.plane = m_segment.plane,
            .erase = edit.erase,
            .lockedLabels = m_locked,
            .bricks = placesOf(shellAround(*inside, size), size)}};
}

} // namespace core
