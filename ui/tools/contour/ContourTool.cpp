// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourTool.h"

#include "core/session/SegmentWork.h"
#include "ui/base/Theme.h"
#include "ui/settings/growth/SeedValues.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/contour/ContourOptions.h"
#include "ui/tools/contour/ContourTexts.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

bool isInverseContour(const PointerSample& sample)
{
    return sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
}

} // namespace

ContourTool::ContourTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_run(workspace)
    , m_look(workspace)
{
    connect(&m_look, &SketchLook::found, this, &ContourTool::takeValues);
    connect(&m_run, &ContourRun::changed, this, &ContourTool::showRun);
    connect(&m_run, &ContourRun::stateChanged, this, &Tool::overlayChanged);
    connect(&m_drawing, &ContourDrawing::drawn, this, &Tool::overlayChanged);
    connect(&m_ghost, &ContourGhost::drawn, this, &Tool::overlayChanged);
    connect(&m_run, &ContourRun::failed, &workspace, &Workspace::fail);
    connect(&m_run, &ContourRun::ranOutOfMemory, this, [this] {
        m_workspace.say(tr("The contour evolves no further: that would take more memory than there "
                           "is. What is shown can be accepted"));
    });
    connect(&m_run, &ContourRun::foundNothing, this,
        [this] { m_workspace.say(nothingToEvolveText(m_erases, !m_bubblesLps.empty())); });
    connect(&workspace, &Workspace::growSettingsChanged, this, &ContourTool::follow);
    connect(&workspace, &Workspace::brushSettingsChanged, this, &ContourTool::follow);
    connect(&workspace, &Workspace::editableChanged, this, &ContourTool::follow);
    connect(&workspace, &Workspace::activeSegmentChanged, this, [this] {
        if (m_workspace.activeSegment() != m_segment)
            putAway();
        Q_EMIT overlayChanged();
    });
}

QString ContourTool::name() const
{
    return tr("Contour");
}

QString ContourTool::iconName() const
{
    return QStringLiteral("contour");
}

QString ContourTool::hint() const
{
    return contourHint(m_settings.start);
}

QString ContourTool::keys() const
{
    return tr("Enter accepts, Esc aborts · ← → generations · Shift+wheel bubble, "
              "Shift+click one more · Ctrl erases");
}

QString ContourTool::target() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    return contourTarget(session->document().segment(m_workspace.activeSegment()), m_isInverse,
        m_settings.startsFromBubbles());
}

QWidget* ContourTool::createOptions(QWidget* parent)
{
    return new ContourOptions(m_workspace, *this, parent);
}

QJsonObject ContourTool::settingsJson() const
{
    return m_settings.json();
}

void ContourTool::applySettings(const QJsonObject& settings)
{
    ContourSettings now = m_settings;
    now.read(settings);
    setSettings(now);
}

void ContourTool::setSettings(const ContourSettings& settings)
{
    if (settings == m_settings)
        return;
    m_settings = settings;
    Q_EMIT settingsChanged();
    Q_EMIT nameChanged(); // what a click does
    follow();
    Q_EMIT overlayChanged();
}

double ContourTool::edgeGradient() const
{
    const core::Volume* volume = m_workspace.volume();
    if (m_settings.edgeGradient > 0.0 || !volume)
        return m_settings.edgeGradient;
    GrowSettings suitable;
    chooseLimits(suitable, *volume);
    return suitable.gradient.value;
}

core::EvolveContour ContourTool::edit() const
{
    constexpr double half = 0.5;
    constexpr double perCent = 0.01;
    const GrowSettings& growth = m_workspace.growSettings();
    core::EvolveContour edit{.segment = m_segment,
        .lower = growth.lower,
        .upper = growth.upper,
        .softness = m_settings.softness * perCent * half * (growth.upper - growth.lower),
        .edge = m_settings.edge,
        .smoothness = m_settings.smoothness,
        .generations = m_settings.generations,
        .overwriteUnlocked = m_workspace.brushSettings(Workspace::Brush::Paint).overwriteUnlocked,
        .editable = m_workspace.editableRange(),
        .round = true};
    if (edit.edge > 0)
        edit.edgeGradient = edgeGradient();
    if (!m_bubblesLps.empty()) {
        edit.bubbleLps = m_bubblesLps.front();
        edit.bubbleMm = bubbleMm(m_ofBubbles);
    }
    if (m_bubblesLps.size() > 1)
        edit.furtherBubblesLps.emplace(m_bubblesLps.begin() + 1, m_bubblesLps.end());
    if (m_erases) {
        edit.erase = true;
        edit.overwriteUnlocked = false;
    }
    return edit;
}

/// Whether a click in a slice may blow a bubble there; if not, it says why.
bool ContourTool::mayBeginAt(const glm::dvec3& placeLps) const
{
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    if (geometry.contains(glm::ivec3(glm::floor(geometry.toIndex(placeLps) + 0.5))))
        return true;
    m_workspace.say(tr("Click inside the volume"));
    return false;
}

std::vector<glm::dvec3> ContourTool::startingBubbles(const glm::dvec3& placeLps) const
{
    if (m_settings.startsFromBubbles())
        return {placeLps};
    std::vector<glm::dvec3> places;
    if (m_settings.start == Start::Seeds) {
        for (const gpu::SceneSeed& seed : m_workspace.seeds().seeds()) {
            if (int(seed.label) == m_workspace.activeSegment())
                places.push_back(seed.lps);
        }
    }
    return places;
}

void ContourTool::start(const glm::dvec3& placeLps, bool erases)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (m_settings.startsFromBubbles() && !mayBeginAt(placeLps))
        return;
    const bool isEmpty = session->foreseenDocument().segments.empty();
    if (erases && isEmpty)
        return m_workspace.say(tr("There is no segment to erase"));
    if (!m_settings.startsFromBubbles() && isEmpty)
        return m_workspace.say(tr("There is no segment to begin with: click a bubble instead"));
    const std::vector<glm::dvec3> bubblesLps = startingBubbles(placeLps);
    if (m_settings.start == Start::Seeds && bubblesLps.empty())
        return m_workspace.say(tr("The segment has no seeds that wait for a growth: sketch some "
                                  "with Seed, or click a bubble instead"));
    // What it would begin with is about to change.
    if (!session->segmentWork().isPreview() && session->segmentWork().percent())
        return m_workspace.say(tr("A segment is being worked out; Esc abandons it"));
    drop();
    if (isEmpty) {
        m_segment = 0; // Esc is to leave nothing
    } else {
        const core::Result<int> label = ensureActiveSegment(m_workspace);
        if (!label)
            return m_workspace.fail(label.error());
        m_segment = *label;
    }
    m_erases = erases;
    m_bubblesLps = bubblesLps;
    m_ofBubbles = m_pressure;
    m_added.clear();
    evolve();
}

/// Whether a further bubble would be one of the open contour.
bool ContourTool::takesBubbles() const
{
    return (m_run.isOpen() || m_awaitsValues) && !(m_erases && m_bubblesLps.empty());
}

bool ContourTool::wantsFurtherBubble(const PointerSample& sample) const
{
    return m_settings.start == Start::Bubbles || sample.modifiers.testFlag(Qt::ShiftModifier);
}

void ContourTool::addBubble(const glm::dvec3& placeLps, bool erases)
{
    if (!m_workspace.session() || !takesBubbles())
        return start(placeLps, erases);
    if (!mayBeginAt(placeLps))
        return;
    m_bubblesLps.push_back(placeLps);
    m_added.push_back(
        {.lower = m_workspace.growSettings().lower, .upper = m_workspace.growSettings().upper});
    // After it there may be more to come than what was played. Whoever looks at a generation before
    // stays there.
    const core::ContourTrack* track = m_run.track();
    m_playsOn = m_run.isPlaying() || !track || track->shown() == track->known();
    evolve();
    Q_EMIT stepsChanged();
}

void ContourTool::takeStepBack()
{
    if (m_added.empty())
        return drop();
    m_bubblesLps.pop_back();
    GrowSettings growth = m_workspace.growSettings();
    growth.lower = m_added.back().lower;
    growth.upper = m_added.back().upper;
    m_added.pop_back();
    m_playsOn = false;
    m_workspace.setGrowSettings(growth);
    evolve();
    Q_EMIT stepsChanged();
}

QString ContourTool::stepText() const
{
    return !m_added.empty() ? tr("the last bubble") : tr("the contour that is watched");
}

/// Begins with the bubbles that there are, or goes on with them, once their values are known.
void ContourTool::evolve()
{
    m_awaitsValues = !m_bubblesLps.empty() && m_settings.valuesOfBubble;
    if (!m_awaitsValues) {
        m_look.drop();
        begin();
        return;
    }
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    core::SeedSketch sketch;
    for (const glm::dvec3& placeLps : m_bubblesLps)
        sketch.voxels.emplace_back(glm::floor(geometry.toIndex(placeLps) + 0.5));
    m_look.ask({std::move(sketch)});
}

void ContourTool::begin()
{
    m_run.begin(edit());
    if (std::exchange(m_playsOn, false))
        m_run.setPlaying(true);
}

/// As growth takes its interval from a sketch.
void ContourTool::takeValues(const core::SketchedCodes& sketched)
{
    const core::Volume* volume = m_workspace.volume();
    if (!m_awaitsValues || !volume)
        return;
    m_awaitsValues = false;
    if (const auto offered = offeredValues(*volume, sketched, usualTolerance)) {
        GrowSettings growth = m_workspace.growSettings();
        growth.lower = offered->first;
        growth.upper = offered->second;
        m_workspace.setGrowSettings(growth);
    }
    begin();
}

void ContourTool::drop()
{
    m_awaitsValues = false;
    m_look.drop();
    m_run.drop();
}

void ContourTool::follow()
{
    if (!m_run.isOpen())
        return;
    // Whoever changes to the other start wants it the next time.
    m_run.begin(edit());
}

void ContourTool::accept()
{
    std::optional<core::EvolveContour> shown = m_run.shownEdit();
    if (!shown)
        return m_workspace.say(!m_run.isOpen() ? tr("There is no contour to accept")
                : m_run.isWorking()            ? tr("The contour is still being worked out")
                                               : tr("The contour has not moved yet"));
    drop();
    if (shown->segment == 0) {
        const core::Result<int> label = addSegment(m_workspace);
        if (!label)
            return m_workspace.fail(label.error());
        shown->segment = *label;
    }
    evolveContour(m_workspace, *shown);
}

void ContourTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !view.isSlice())
        return;
    hover(sample, view);
    m_pressure.begin(
        sample, m_settings.radiusByPressure && m_settings.startsFromBubbles() && !m_adds);
    m_click = Click{.placeLps = view.toLps(sample.position),
        .adds = wantsFurtherBubble(sample),
        .erases = isInverseContour(sample)};
    // How hard the pen was pressed at most is known only when it is lifted.
    if (!m_pressure.counts())
        endClick();
}

void ContourTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_click)
        return;
    m_pressure.extend(sample);
    m_click->placeLps = view.toLps(sample.position); // where its ring is seen
    showCursor(sample.position, view.view);
}

void ContourTool::release(const PointerSample&, const ViewContext&)
{
    endClick();
}

void ContourTool::endClick()
{
    if (const std::optional<Click> click = std::exchange(m_click, std::nullopt)) {
        if (click->adds)
            addBubble(click->placeLps, click->erases);
        else
            start(click->placeLps, click->erases);
    }
    m_pressure.end();
}

void ContourTool::dropClick()
{
    m_click.reset();
    m_pressure.end();
    Q_EMIT overlayChanged();
}

double ContourTool::bubbleMm(const StrokePressure& pressed) const
{
    return pressed.of(m_settings.bubbleMm, ContourSettings::minimumBubbleMm);
}

void ContourTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_adds = wantsFurtherBubble(sample) && takesBubbles();
    m_isInverse = m_adds ? m_erases : isInverseContour(sample);
    CursorTool::hover(sample, view);
}

void ContourTool::cancel()
{
    if (m_click)
        dropClick(); // Esc once more ends what is open
    else if (m_run.isOpen() || m_awaitsValues)
        drop();
    else if (core::EditSession* session = m_workspace.session();
             session && !session->segmentWork().isPreview()) // which is a dialog's
        session->segmentWork().abort();
}

/// A peel is kept here; a step made of a contour would take away what a redo leads to.
void ContourTool::putAway()
{
    if (m_click)
        dropClick();
    if (!m_run.isOpen() && !m_awaitsValues)
        return;
    drop();
    m_workspace.say(tr("The contour was dropped, as nobody had accepted it; nothing has changed"));
}

bool ContourTool::pressKey(int key)
{
    if (!m_run.isOpen())
        return false;
    const int shown = m_run.track() ? m_run.track()->shown() : 0;
    if (key == Qt::Key_Return || key == Qt::Key_Enter)
        accept();
    else if (key == Qt::Key_Left)
        m_run.goTo(shown - 1);
    else if (key == Qt::Key_Right)
        m_run.goTo(shown + 1);
    else
        return false;
    return true;
}

void ContourTool::changeRadius(int steps)
{
    ContourSettings now = m_settings;
    now.changeBubble(steps);
    setSettings(now);
}

void ContourTool::showRun()
{
    if (!m_run.track()) {
        m_drawing.forget();
        m_ghost.forget();
    }
    if (std::exchange(m_wasOpen, m_run.isOpen()) != m_run.isOpen())
        Q_EMIT stepsChanged();
    Q_EMIT overlayChanged();
}

QString ContourTool::intervalText() const
{
    if (!m_run.isOpen() && m_settings.start != Start::Segment && m_settings.valuesOfBubble)
        return m_settings.start == Start::Seeds ? tr("values as around the seeds")
                                                : tr("values as around the bubble");
    return contourInterval(m_workspace.growSettings(), *m_workspace.volume());
}

QString ContourTool::shownText() const
{
    const core::ContourTrack* track = m_run.track();
    const core::Volume* volume = m_workspace.volume();
    return track && volume ? contourText(*track, *volume, m_erases) : QString();
}

QColor ContourTool::ringColour() const
{
    return m_isInverse ? theme::caution : toolColour();
}

void ContourTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view))
        return;
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    if (const std::shared_ptr<const core::ContourState>& state = m_run.state()) {
        const core::Segment* segment = session->document().segment(m_segment);
        const QColor colour(segment ? segment->rgb : nextSegmentColour(session->document()));
        if (view.isSlice())
            m_drawing.paint(painter, view, state, geometry, colour);
        else
            m_ghost.paint(painter, view, state, geometry, colour);
    }
    if (!isUnderPointer(view) || !view.isSlice())
        return;
    const bool isBubble = m_click || m_adds || (m_settings.startsFromBubbles() && !m_run.isOpen());
    // A further bubble is as large as the contour's first one.
    const double radius =
        isBubble ? bubbleMm(m_adds ? m_ofBubbles : m_pressure) / view.mmPerPixel() : 6.0;
    if (isBubble)
        drawCursorRing(painter, cursor(), radius, ringColour(), true);
    QStringList lines{m_adds ? tr("one more bubble") : m_run.track() ? shownText() : target()};
    lines += intervalText();
    if (const QString editable = m_workspace.editableText(); !editable.isEmpty())
        lines += editable;
    drawCursorLabel(painter, view.sizePixels, cursor(), radius, lines);
}

} // namespace ui
