// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/nudge/NudgeTool.h"

#include "core/edits/EditQuantise.h"
#include "core/edits/engine/NudgeDisc.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/WaitingStroke.h"
#include "ui/tools/common/BrushTool.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/nudge/NudgeOptions.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>
#include <utility>
#include <vector>

namespace ui {

namespace {

bool isInverseNudge(const PointerSample& sample)
{
    return sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
}

} // namespace

/// Where the pen was, and how firmly it was pressed there.
struct NudgeTool::Place {
    glm::dvec3 lps{0.0};
    double share = 1.0; ///< of the radius
};

/// From pen-down until the session has been told all of it.
struct NudgeTool::Stroke {
    ViewContext view; ///< of pen-down; holds for the whole stroke
    core::PaintStroke edit; ///< with the first point alone
    bool isInverse = false;
    bool fits = false;
    bool isBegun = false; ///< in the session
    bool isReleased = false;
    bool isPressed = false; ///< the radius follows the pressure
    std::vector<Place> waiting{}; ///< that the session was not told yet
    Place last{};

    [[nodiscard]] core::PathPoints points(const std::vector<Place>& places) const
    {
        core::PathPoints points;
        for (const Place& place : places) {
            points.pointsLps.push_back(place.lps);
            if (isPressed)
                points.pressures.push_back(place.share);
        }
        return points;
    }
};

NudgeTool::NudgeTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
    , m_aim(workspace)
{
    connect(&workspace, &Workspace::activeSegmentChanged, this, [this] {
        m_start.reset();
        lookAhead();
        Q_EMIT overlayChanged();
    });
    connect(&workspace, &Workspace::documentChanged, this, &NudgeTool::lookAhead);
    // A stroke ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_stroke.reset();
        m_start.reset();
        m_looksAgain = false;
    });
}

NudgeTool::~NudgeTool() = default;

QString NudgeTool::name() const
{
    return tr("Nudge");
}

QString NudgeTool::iconName() const
{
    return QStringLiteral("nudge");
}

QString NudgeTool::hint() const
{
    return tr("Nudge: push the border on a slice, from inside outwards, from beside it inwards; "
              "Ctrl or the eraser end the other way round");
}

QString NudgeTool::keys() const
{
    return tr("[ ] radius · Ctrl inverts · Esc cancels");
}

QWidget* NudgeTool::createOptions(QWidget* parent)
{
    return new NudgeOptions(m_workspace, *this, parent);
}

QJsonObject NudgeTool::settingsJson() const
{
    return {{QStringLiteral("radiusMm"), m_settings.radiusMm},
        {QStringLiteral("fits"), m_settings.fits},
        {QStringLiteral("radiusByPressure"), m_settings.radiusByPressure}};
}

void NudgeTool::applySettings(const QJsonObject& settings)
{
    Settings now = m_settings;
    now.fits = settings[QLatin1String("fits")].toBool(now.fits);
    now.radiusByPressure = settings[QLatin1String("radiusByPressure")].toBool(now.radiusByPressure);
    const double radiusMm = settings[QLatin1String("radiusMm")].toDouble(now.radiusMm);
    if (radiusMm >= BrushTool::minimumRadiusMm && radiusMm <= BrushTool::maximumRadiusMm)
        now.radiusMm = radiusMm;
    setSettings(now);
}

void NudgeTool::setSettings(const Settings& settings)
{
    if (settings == m_settings)
        return;
    m_settings = settings;
    lookAhead();
    Q_EMIT settingsChanged();
    Q_EMIT overlayChanged();
}

void NudgeTool::changeRadius(int steps)
{
    Settings now = m_settings;
    now.radiusMm = BrushTool::radiusAfter(now.radiusMm, steps);
    setSettings(now);
}

const core::Segment* NudgeTool::nudged() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return nullptr;
    const core::Document& document = session->document();
    const core::Segment* active = document.segment(m_workspace.activeSegment());
    if (active || document.segments.empty())
        return active;
    return &document.segments.front();
}

core::PaintStroke NudgeTool::strokeAt(
    const QPointF& pixel, const ViewContext& view, int segment) const
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    core::PaintStroke stroke{.segment = segment};
    stroke.path.radiusMm = m_settings.radiusMm;
    stroke.path.shape = core::BrushPath::Shape::Disc;
    stroke.path.normalLps = glm::normalize(glm::cross(slice.rightLps, slice.downLps));
    stroke.path.pointsLps = {view.toLps(pixel)};
    const Workspace::BrushSettings& limits = m_workspace.brushSettings(Workspace::Brush::Paint);
    if (limits.onlyBetween) {
        stroke.lower = std::min(limits.lower, limits.upper);
        stroke.upper = std::max(limits.lower, limits.upper);
    }
    stroke.editable = m_workspace.editableRange();
    stroke.tool = core::PaintStroke::Tool::Nudge;
    return core::quantised(core::Edit(stroke)).get<core::PaintStroke>();
}

void NudgeTool::press(const PointerSample& sample, const ViewContext& view)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view))
        return;
    if (m_stroke)
        return sayStrokeWaits(m_workspace);
    showCursor(sample, view);
    if (!nudged())
        return m_workspace.say(tr("There is no segment to nudge"));
    const core::Result<int> label = ensureActiveSegment(m_workspace);
    if (!label)
        return m_workspace.fail(label.error());
    // The stroke would end a growth that runs; what that has grown by now counts, too.
    session->closeOpen();
    m_stroke = std::make_unique<Stroke>(Stroke{.view = view,
        .edit = strokeAt(sample.position, view, *label),
        .isInverse = isInverseNudge(sample),
        .fits = m_settings.fits,
        .isPressed = m_settings.radiusByPressure && sample.isPen});
    m_stroke->last = {.lps = view.toLps(sample.position), .share = pressedShare(sample)};
    if (m_stroke->isPressed)
        m_stroke->edit.path.pressures = std::vector<double>{m_stroke->last.share};
    m_looksAgain = false;
    const core::Result<void> asked = m_aim.ask(m_stroke->edit.path, *label,
        [this](const core::Result<core::NudgeStart>& start) { begin(start); });
    if (!asked) {
        m_stroke.reset();
        m_workspace.fail(asked.error());
    }
}

void NudgeTool::begin(const core::Result<core::NudgeStart>& start)
{
    core::EditSession* session = m_workspace.session();
    if (!start || !session) {
        m_stroke.reset();
        if (!start)
            m_workspace.fail(start.error());
        return Q_EMIT stepsChanged();
    }
    if (m_stroke->isReleased && isStrokeOpen(*session)) {
        m_stroke.reset();
        sayStrokeCameTooLate(m_workspace);
        return Q_EMIT stepsChanged();
    }
    m_start = *start;
    core::PaintStroke edit = m_stroke->edit;
    edit.erase = start->isInside == m_stroke->isInverse;
    if (m_stroke->fits)
        edit.path.radiusMm = core::fittingRadiusMm(*start);
    if (!edit.erase) {
        edit.overwriteUnlocked =
            m_workspace.brushSettings(Workspace::Brush::Paint).overwriteUnlocked;
        edit.seeds = takesPartInGrowth(session->history(), edit.segment);
    }
    m_stroke->edit = edit;
    if (const core::Result<void> begun = session->begin(core::Edit(edit)); !begun) {
        m_stroke.reset();
        m_workspace.fail(begun.error());
        Q_EMIT stepsChanged();
        return Q_EMIT overlayChanged();
    }
    m_stroke->isBegun = true;
    if (!m_stroke->waiting.empty())
        session->extend(m_stroke->points(std::exchange(m_stroke->waiting, {})));
    if (m_stroke->isReleased)
        finish();
    Q_EMIT overlayChanged();
}

void NudgeTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_stroke || m_stroke->isReleased || view.view != m_stroke->view.view)
        return;
    const Place place{.lps = m_stroke->view.toLps(sample.position), .share = pressedShare(sample)};
    const Place& last = m_stroke->last;
    const bool widens = m_stroke->isPressed && pressesHarder(place.share, last.share);
    if (place.lps != last.lps || widens) {
        m_stroke->last = place;
        if (m_stroke->isBegun)
            m_workspace.session()->extend(m_stroke->points({place}));
        else
            m_stroke->waiting.push_back(place);
    }
    showCursor(sample, view);
}

void NudgeTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_stroke)
        return;
    m_stroke->isReleased = true;
    if (m_stroke->isBegun)
        finish();
    else
        Q_EMIT stepsChanged();
    showCursor(sample, view);
}

void NudgeTool::finish()
{
    m_workspace.session()->end(core::Ending::Commit);
    m_stroke.reset();
    Q_EMIT stepsChanged();
    lookAhead();
}

bool NudgeTool::canTakeStepBack() const
{
    return m_stroke && m_stroke->isReleased;
}

QString NudgeTool::stepText() const
{
    return waitingStrokeText();
}

void NudgeTool::cancel()
{
    if (!m_stroke || !m_stroke->isReleased)
        drop();
}

void NudgeTool::drop()
{
    m_aim.drop();
    m_looksAgain = false;
    if (!m_stroke)
        return;
    const std::unique_ptr<Stroke> stroke = std::exchange(m_stroke, nullptr);
    core::EditSession* session = m_workspace.session();
    if (session && stroke->isBegun)
        session->end(core::Ending::Rollback);
    m_workspace.say(tr("The stroke was taken back"));
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

void NudgeTool::lookAhead()
{
    const core::Segment* segment = nudged();
    if (!m_view || m_stroke || !segment || m_workspace.activeTool() != this)
        return;
    m_looksAgain = m_aim.busy();
    if (m_looksAgain)
        return;
    const core::PaintStroke stroke = strokeAt(m_cursor, *m_view, segment->label);
    const core::Result<void> asked =
        m_aim.ask(stroke.path, segment->label, [this](const core::Result<core::NudgeStart>& start) {
            m_start = start ? std::optional(*start) : std::nullopt;
            Q_EMIT overlayChanged();
            if (std::exchange(m_looksAgain, false))
                lookAhead();
        });
    if (!asked)
        m_start.reset();
}

void NudgeTool::hover(const PointerSample& sample, const ViewContext& view)
{
    showCursor(sample, view);
    lookAhead();
}

void NudgeTool::leave()
{
    m_view.reset();
    if (!m_stroke) {
        m_aim.drop();
        m_start.reset();
    }
    Q_EMIT overlayChanged();
}

void NudgeTool::showCursor(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_view = view;
    m_isInverse = m_stroke ? m_stroke->isInverse : isInverseNudge(sample);
    m_share = m_stroke && m_stroke->isPressed ? pressedShare(sample) : 1.0;
    Q_EMIT overlayChanged();
}

std::optional<bool> NudgeTool::pushesOutwards() const
{
    if (m_stroke && m_stroke->isBegun)
        return !m_stroke->edit.erase;
    return m_start ? std::optional(m_start->isInside != m_isInverse) : std::nullopt;
}

double NudgeTool::radiusMm() const
{
    if (m_stroke && m_stroke->isBegun)
        return m_stroke->edit.path.radiusMm;
    if (!m_settings.fits || !m_start)
        return m_settings.radiusMm;
    return std::min(m_settings.radiusMm, core::fittingRadiusMm(*m_start));
}

QString NudgeTool::target() const
{
    if (!m_workspace.session())
        return {};
    const core::Segment* segment = nudged();
    if (!segment)
        return tr("no segment to nudge");
    if (segment->locked)
        return tr("%1 is locked").arg(segment->name);
    const std::optional<bool> outwards = pushesOutwards();
    if (!outwards)
        return tr("nudges %1").arg(segment->name);
    return (*outwards ? tr("pushes %1 outwards") : tr("pushes %1 inwards")).arg(segment->name);
}

void NudgeTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !m_view || m_view->view != view.view || !worksIn(view))
        return;
    const std::optional<bool> outwards = pushesOutwards();
    // Outwards and inwards differ in colour, in line and in words.
    const QColor colour = !outwards ? toolColour() : *outwards ? theme::good : theme::caution;
    const double radius = m_share * radiusMm() / view.mmPerPixel();
    drawCursorRing(painter, m_cursor, radius, colour, outwards == false);
    drawCursorCross(painter, m_cursor, colour); // what lies under it decides
    const QString size = tr("radius %1 mm").arg(numberText(radiusMm(), 1));
    QStringList lines{target(),
        radiusMm() < m_settings.radiusMm ? tr("%1, as far as the border").arg(size) : size};
    if (const QString limits = limitsText(m_workspace); !limits.isEmpty())
        lines += limits;
    drawCursorLabel(painter, view.sizePixels, m_cursor, radius, lines);
}

} // namespace ui
