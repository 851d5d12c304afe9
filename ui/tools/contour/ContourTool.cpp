// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourTool.h"

#include "core/session/SegmentWork.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/settings/SeedValues.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/contour/ContourOptions.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double mm3PerMillilitre = 1000.0;

/// An integer of a kept session, if it is one within bounds.
void readWhole(const QJsonObject& json, const char* field, int least, int greatest, int& value)
{
    const int kept = json[QLatin1String(field)].toInt(least - 1);
    if (kept >= least && kept <= greatest)
        value = kept;
}

void readNumber(
    const QJsonObject& json, const char* field, double least, double greatest, double& value)
{
    const double kept = json[QLatin1String(field)].toDouble(least - 1.0);
    if (kept >= least && kept <= greatest)
        value = kept;
}

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
    connect(&m_run, &ContourRun::foundNothing, this, [this] {
        m_workspace.say(!m_erases ? tr("The segment has no voxels to begin with: click a bubble "
                                       "instead")
                : m_bubbleLps     ? tr("The segment has no voxels in the bubble")
                                  : tr("The segment has no voxels to erase"));
    });
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
    return m_settings.fromSegment
        ? tr("Contour: click a slice and accept what the segment evolves to; Ctrl or the eraser "
             "end erases from all around it")
        : tr("Contour: click a bubble on a slice and accept what evolves; Ctrl or the eraser end "
             "erases");
}

QString ContourTool::keys() const
{
    return tr("Enter accepts, Esc aborts · ← → generations · Shift+wheel bubble · Ctrl erases");
}

QString ContourTool::target() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(m_workspace.activeSegment());
    if (!segment)
        return m_isInverse           ? tr("no segment to erase")
            : m_settings.fromSegment ? tr("no segment to begin with")
                                     : tr("fills a new segment");
    return (segment->locked ? tr("%1 is locked")
            : m_isInverse   ? tr("erases %1")
                            : tr("evolves %1"))
        .arg(segment->name);
}

QWidget* ContourTool::createOptions(QWidget* parent)
{
    return new ContourOptions(m_workspace, *this, parent);
}

QJsonObject ContourTool::settingsJson() const
{
    return {{QStringLiteral("fromSegment"), m_settings.fromSegment},
        {QStringLiteral("bubbleMm"), m_settings.bubbleMm},
        {QStringLiteral("valuesOfBubble"), m_settings.valuesOfBubble},
        {QStringLiteral("softness"), m_settings.softness},
        {QStringLiteral("smoothness"), m_settings.smoothness},
        {QStringLiteral("edge"), m_settings.edge},
        {QStringLiteral("edgeGradient"), m_settings.edgeGradient},
        {QStringLiteral("generations"), m_settings.generations}};
}

void ContourTool::applySettings(const QJsonObject& settings)
{
    constexpr int whole = 100;
    Settings now = m_settings;
    now.fromSegment = settings[QLatin1String("fromSegment")].toBool(now.fromSegment);
    readNumber(settings, "bubbleMm", minimumBubbleMm, maximumBubbleMm, now.bubbleMm);
    now.valuesOfBubble = settings[QLatin1String("valuesOfBubble")].toBool(now.valuesOfBubble);
    readWhole(settings, "softness", 0, whole, now.softness);
    readWhole(settings, "smoothness", 0, whole, now.smoothness);
    readWhole(settings, "edge", 0, whole, now.edge);
    readNumber(settings, "edgeGradient", 0.0, maximumGradient, now.edgeGradient);
    readWhole(settings, "generations", 1, core::mostContourGenerations, now.generations);
    setSettings(now);
}

void ContourTool::setSettings(const Settings& settings)
{
    if (settings == m_settings)
        return;
    m_settings = settings;
    Q_EMIT settingsChanged();
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
        .bubbleLps = m_bubbleLps,
        .generations = m_settings.generations,
        .overwriteUnlocked = m_workspace.brushSettings(Workspace::Brush::Paint).overwriteUnlocked,
        .editable = m_workspace.editableRange(),
        .round = true};
    if (edit.edge > 0)
        edit.edgeGradient = edgeGradient();
    if (edit.bubbleLps)
        edit.bubbleMm = m_settings.bubbleMm;
    if (m_erases) {
        edit.erase = true;
        edit.overwriteUnlocked = false;
    }
    return edit;
}

void ContourTool::start(const glm::dvec3& placeLps, bool erases)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const glm::ivec3 voxel(glm::floor(geometry.toIndex(placeLps) + 0.5));
    if (!m_settings.fromSegment && !geometry.contains(voxel))
        return m_workspace.say(tr("Click inside the volume"));
    if (erases && session->foreseenDocument().segments.empty())
        return m_workspace.say(tr("There is no segment to erase"));
    if (m_settings.fromSegment && session->foreseenDocument().segments.empty())
        return m_workspace.say(tr("There is no segment to begin with: click a bubble instead"));
    // What it would begin with is about to change.
    if (!session->segmentWork().isPreview() && session->segmentWork().percent())
        return m_workspace.say(tr("A segment is being worked out; Esc abandons it"));
    drop();
    if (session->foreseenDocument().segments.empty()) {
        m_segment = 0; // Esc is to leave nothing
    } else {
        const core::Result<int> label = ensureActiveSegment(m_workspace);
        if (!label)
            return m_workspace.fail(label.error());
        m_segment = *label;
    }
    m_erases = erases;
    m_bubbleLps.reset();
    if (!m_settings.fromSegment)
        m_bubbleLps = placeLps;
    m_awaitsValues = m_bubbleLps && m_settings.valuesOfBubble;
    if (m_awaitsValues)
        m_look.ask({{.voxels = {voxel}}});
    else
        m_run.begin(edit());
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
    m_run.begin(edit());
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
    start(view.toLps(sample.position), isInverseContour(sample));
}

void ContourTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_isInverse = isInverseContour(sample);
    CursorTool::hover(sample, view);
}

void ContourTool::cancel()
{
    if (m_run.isOpen() || m_awaitsValues)
        drop();
    else if (core::EditSession* session = m_workspace.session();
             session && !session->segmentWork().isPreview()) // which is a dialog's
        session->segmentWork().abort();
}

/// A peel is kept here; a step made of a contour would take away what a redo leads to.
void ContourTool::putAway()
{
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
    Settings now = m_settings;
    const double step = now.bubbleMm < 10.0 ? 0.5 : 1.0;
    now.bubbleMm = std::clamp(now.bubbleMm + steps * step, minimumBubbleMm, maximumBubbleMm);
    setSettings(now);
}

void ContourTool::showRun()
{
    if (!m_run.track()) {
        m_drawing.forget();
        m_ghost.forget();
    }
    if (m_wasOpen != m_run.isOpen()) {
        m_wasOpen = m_run.isOpen();
        Q_EMIT stepsChanged();
    }
    Q_EMIT overlayChanged();
}

QString ContourTool::intervalText() const
{
    if (!m_run.isOpen() && !m_settings.fromSegment && m_settings.valuesOfBubble)
        return tr("values as around the bubble");
    const core::Volume& volume = *m_workspace.volume();
    const GrowSettings& growth = m_workspace.growSettings();
    const double span = volume.maximum - volume.minimum;
    return tr("%1 … %2").arg(
        valueText(growth.lower, {}, span), valueText(growth.upper, volume.unit, span));
}

QString ContourTool::shownText() const
{
    const core::ContourTrack* track = m_run.track();
    const core::Volume* volume = m_workspace.volume();
    if (!track || !volume)
        return {};
    const double ml = volume->geometry.voxelVolumeMm3() / mm3PerMillilitre;
    if (m_erases)
        return tr("generation %1 · erases %2")
            .arg(QString::number(track->shown()), volumeText(double(track->lost()) * ml));
    return tr("generation %1 · +%2, −%3")
        .arg(QString::number(track->shown()), volumeText(double(track->gained()) * ml),
            volumeText(double(track->lost()) * ml));
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
    if (!m_settings.fromSegment && !m_run.isOpen())
        drawCursorRing(
            painter, cursor(), m_settings.bubbleMm / view.mmPerPixel(), ringColour(), true);
    QStringList lines{m_run.track() ? shownText() : target()};
    lines += intervalText();
    if (const QString editable = m_workspace.editableText(); !editable.isEmpty())
        lines += editable;
    const double radius =
        m_settings.fromSegment || m_run.isOpen() ? 6.0 : m_settings.bubbleMm / view.mmPerPixel();
    drawCursorLabel(painter, view.sizePixels, cursor(), radius, lines);
}

} // namespace ui
