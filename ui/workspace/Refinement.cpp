// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/Refinement.h"

#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/measure/MeasuredSize.h"
#include "core/refine/mesh/ShownSurface.h"
#include "core/session/SessionSurface.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <utility>

namespace ui {

Refinement::Refinement(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &Refinement::follow);
    connect(&workspace, &Workspace::sessionClosing, this, [this] {
        m_contours.clear();
        m_taken.clear();
        Q_EMIT contoursChanged();
    });
    connect(&workspace, &Workspace::failed, this, [this] {
        if (isPreviewing())
            Q_EMIT contoursChanged(); // it may be refused
        else
            returnRefused();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            followTaken();
            if (change.what == core::DocumentChange::What::Surface
                || change.what == core::DocumentChange::What::Segments)
                Q_EMIT changed();
        });
}

/// Whether the contours that were taken are among those that are drawn: they have come back.
bool Refinement::areTakenBack() const
{
    return m_contours.size() >= m_taken.size()
        && std::equal(m_taken.begin(), m_taken.end(), m_contours.begin());
}

/// Whether the template that was taken is a row by now.
bool Refinement::isTakenThrough() const
{
    const std::vector<core::HistoryRow>& rows = m_workspace.session()->history().rows();
    const auto first = rows.begin() + std::ptrdiff_t(std::min(m_rowsAtTaking, rows.size()));
    return std::any_of(first, rows.end(),
        [](const core::HistoryRow& row) { return row.edit.is<core::ApplyTemplate>(); });
}

/// Once a template is a row its contours are of no use any more.
void Refinement::followTaken()
{
    if (m_taken.empty() || !m_workspace.session() || !isTakenThrough())
        return;
    // It was through before it could be aborted.
    const std::size_t back = areTakenBack() ? m_taken.size() : 0;
    m_taken.clear();
    if (back == 0)
        return;
    m_contours.erase(m_contours.begin(), m_contours.begin() + std::ptrdiff_t(back));
    Q_EMIT contoursChanged();
}

/// What was taken before its refusal came is wanted yet. What still moves may have nothing to do
/// with the failure, and takes its contours along once it is through.
void Refinement::returnRefused()
{
    if (m_taken.empty() || !m_workspace.session() || isTakenThrough())
        return;
    const bool wereBack = areTakenBack();
    if (!wereBack)
        m_contours.insert(m_contours.begin(), m_taken.begin(), m_taken.end());
    if (!isAbortable())
        m_taken.clear();
    if (!wereBack)
        Q_EMIT contoursChanged();
}

/// What begins next has nothing to do with a template that came to nothing.
void Refinement::forgetTaken()
{
    if (!isAbortable())
        m_taken.clear();
}

/// Updates come from the thread that deforms: those for pictures go on at once, ours in line. They
/// tell true places; views show unevenly spaced slices as if they were evenly spaced.
void Refinement::follow()
{
    const core::SurfaceUpdate nothing{.isWhole = true, .vertices = {}, .faces = {}};
    core::EditSession* session = m_workspace.session();
    if (!session) {
        m_workspace.frames().updateSurface(nothing);
        take(nothing, std::nullopt);
        return;
    }
    const core::Volume* volume = m_workspace.volume();
    session->surface().setListener([this, &frames = m_workspace.frames(),
                                       geometry = volume
                                           ? volume->geometry
                                           : core::VolumeGeometry()](core::SurfaceUpdate update) {
        std::optional<core::SurfaceUpdate> truth;
        if (!geometry.slicePositions.empty()) {
            truth = update;
            core::moveToShown(update, geometry);
        }
        frames.updateSurface(update);
        QMetaObject::invokeMethod(
            this,
            [this, update = std::move(update), truth = std::move(truth)] { take(update, truth); },
            Qt::QueuedConnection);
    });
}

void Refinement::take(
    const core::SurfaceUpdate& shown, const std::optional<core::SurfaceUpdate>& truth)
{
    m_mirror.take(shown);
    if (truth)
        m_trueMirror.take(*truth);
    else
        m_trueMirror = {};
    m_errors = trueMirror().regions(core::SurfaceMark::Red);
    if (const core::Volume* volume = m_workspace.volume()) {
        for (core::MarkedRegion& error : m_errors)
            error = core::shownRegion(error, volume->geometry);
    }
    m_error = std::min(m_error, int(m_errors.size()) - 1);
    Q_EMIT changed();
}

std::optional<core::RefinedSurface> Refinement::surface() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? session->document().surface : std::nullopt;
}

void Refinement::setLook(const Look& look)
{
    if (look == m_look)
        return;
    m_look = look;
    Q_EMIT lookChanged();
}

void Refinement::setSettings(const Settings& settings)
{
    if (settings == m_settings)
        return;
    m_settings = settings;
    Q_EMIT settingsChanged();
}

gpu::SurfaceColours Refinement::colours() const
{
    gpu::SurfaceColours colours;
    if (const core::Segment* segment =
            m_workspace.session()->document().segment(surface()->segment))
        colours.rgb = segment->rgb;
    if (!m_look.showMarks)
        colours.markOpacity = 0.0f;
    return colours;
}

std::optional<gpu::SceneSurface> Refinement::scene() const
{
    if (!surface() || m_look.opacity <= 0.0f)
        return std::nullopt;
    gpu::SurfaceColours own = colours();
    // What follows the mask, which is all of it at first, is in the segment's colour; only what the
    // user has judged stands out.
    own.yellowShare = 0.0f;
    return gpu::SceneSurface{.style = m_look.style,
        .colours = own,
        .opacity = m_look.opacity,
        .window = m_workspace.windowLevel(),
        .clip = {}};
}

int Refinement::bodiless() const
{
    const bool shown = surface() && !m_mirror.empty() && m_look.opacity > 0.0f
        && m_look.style != gpu::SurfaceStyle::Wireframe;
    return shown ? surface()->segment : 0;
}

int Refinement::mask() const
{
    const bool drawn = surface() && !m_mirror.empty() && (m_look.opacity > 0.0f || m_look.contours);
    return drawn ? surface()->segment : 0;
}

std::optional<gpu::SceneContour> Refinement::contour() const
{
    if (!surface() || !m_look.contours)
        return std::nullopt;
    gpu::SceneContour contour{.colours = colours()};
    contour.colours.markOpacity = m_look.showMarks ? 1.0f : 0.0f;
    return contour;
}

void Refinement::apply(const core::Edit& edit)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (const auto applied = session->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

QString Refinement::caution() const
{
    const auto known = surface();
    const core::Segment* segment =
        known ? m_workspace.session()->document().segment(known->segment) : nullptr;
    if (!segment || !known->isApart())
        return {};
    return tr("%1 differs from its surface").arg(segment->name);
}

void Refinement::addContour(std::vector<glm::dvec3> pointsLps)
{
    dropPreview();
    forgetTaken();
    m_contours.push_back(std::move(pointsLps));
    Q_EMIT contoursChanged();
}

void Refinement::removeContour()
{
    dropPreview();
    if (m_contours.empty())
        return;
    m_contours.pop_back();
    Q_EMIT contoursChanged();
}

void Refinement::removeContourAt(std::size_t place)
{
    dropPreview();
    if (place >= m_contours.size())
        return;
    m_contours.erase(m_contours.begin() + std::ptrdiff_t(place));
    Q_EMIT contoursChanged();
}

void Refinement::clearContours()
{
    dropPreview();
    if (m_contours.empty())
        return;
    m_contours.clear();
    Q_EMIT contoursChanged();
}

bool Refinement::isPreviewing() const
{
    const core::EditSession* session = m_workspace.session();
    return session && session->isOpen<core::ApplyTemplate>();
}

void Refinement::previewTemplate()
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_contours.empty() || isPreviewing())
        return;
    std::vector<std::vector<glm::dvec3>> contours = m_contours;
    for (std::vector<glm::dvec3>& contour : contours) {
        for (glm::dvec3& point : contour)
            point = core::truePlace(m_workspace.volume()->geometry, point);
    }
    const auto begun = session->begin(
        core::ApplyTemplate{.contoursLps = std::move(contours), .rules = core::newestSurfaceRules});
    if (!begun)
        return m_workspace.fail(begun.error());
    Q_EMIT contoursChanged();
}

bool Refinement::canTakeTemplate() const
{
    return isPreviewing() && !m_workspace.session()->openIsRefused();
}

void Refinement::takeTemplate()
{
    if (!canTakeTemplate())
        return dropPreview(); // nothing would come of it, and the contours are wanted yet
    m_rowsAtTaking = m_workspace.session()->history().rows().size();
    m_taken = std::move(m_contours);
    m_contours.clear();
    m_workspace.session()->end(core::Ending::Commit);
    Q_EMIT contoursChanged();
}

void Refinement::dropPreview()
{
    if (!isPreviewing())
        return;
    m_workspace.session()->end(core::Ending::Rollback);
    Q_EMIT contoursChanged();
}

void Refinement::lay(int vertices)
{
    forgetTaken();
    const core::EditSession* session = m_workspace.session();
    if (!session || !session->document().segment(m_workspace.activeSegment()))
        return m_workspace.say(tr("No segment is chosen: choose the one to repair in the list"));
    m_workspace.say(tr("The surface is being laid …"));
    apply(core::LaySurface{.segment = m_workspace.activeSegment(),
        .vertices = vertices,
        .rules = core::newestSurfaceRules});
    Q_EMIT changed();
}

void Refinement::abort()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const bool wasPreviewing = isPreviewing();
    const bool comesBack = session->surface().isAbortable() && !m_taken.empty();
    if (comesBack)
        m_contours = m_taken;
    session->surface().abort();
    if (comesBack || (wasPreviewing && !isPreviewing()))
        Q_EMIT contoursChanged();
}

bool Refinement::isAbortable() const
{
    core::EditSession* session = m_workspace.session();
    return session && session->surface().isAbortable();
}

void Refinement::writeBack()
{
    apply(core::WriteBack{
        .rules = core::newestSurfaceRules, .editable = m_workspace.editableRange()});
}

void Refinement::followMask()
{
    forgetTaken();
    apply(core::FollowMask{.rules = core::newestSurfaceRules});
    Q_EMIT changed();
}

void Refinement::layCrossings()
{
    forgetTaken();
    const auto laid = surface();
    if (!laid)
        return;
    m_workspace.say(tr("Parts that pass through themselves are laid anew, all else stays"));
    apply(core::LaySurface{.segment = laid->segment, .onlyCrossings = true});
    Q_EMIT changed();
}

void Refinement::makeBarrier(bool erase)
{
    apply(core::SurfaceBarrier{.erase = erase});
}

void Refinement::drop()
{
    apply(core::DropSurface{});
}

void Refinement::changeMarks(core::ChangeMarks change)
{
    const bool isYellow = m_settings.mark == core::SurfaceMark::Yellow;
    change.mark = isYellow ? core::SurfaceMark::Red : m_settings.mark;
    apply(change);
}

void Refinement::signOff(int place)
{
    if (place < 0 || place >= int(m_errors.size()))
        return;
    apply(core::ChangeMarks{.mark = core::SurfaceMark::Red,
        .way = core::ChangeMarks::Way::Accept,
        .nearLps = trueMirror().vertex(m_errors[std::size_t(place)].first).positionLps});
}

void Refinement::goToError(int by)
{
    if (m_errors.empty())
        return m_workspace.say(tr("Nothing is red: nothing is left to check"));
    const int count = int(m_errors.size());
    showError(m_error < 0 ? (by > 0 ? 0 : count - 1) : (m_error + by + count) % count);
}

void Refinement::showError(int place)
{
    if (place < 0 || place >= int(m_errors.size()))
        return;
    m_error = place;
    const core::MarkedRegion& error = m_errors[std::size_t(m_error)];
    showRegion(error);
    m_workspace.say(tr("To check: %1 of %2, %3 mm²")
                        .arg(m_error + 1)
                        .arg(m_errors.size())
                        .arg(QString::number(error.areaMm2, 'f', 0)));
}

void Refinement::showRegion(const core::MarkedRegion& region)
{
    m_workspace.setCrosshairLps(region.middleLps);
    Q_EMIT shown(region.middleLps, region.normalLps);
}

} // namespace ui
