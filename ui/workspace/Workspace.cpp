// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/Workspace.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/session/SessionStorage.h"
#include "ui/base/AuthorName.h"
#include "ui/base/Theme.h"
#include "ui/input/Tool.h"
#include "ui/settings/HistoryMemory.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/OpeningView.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/ViewSteps.h"

#include <chrono>
#include <utility>

namespace ui {

Workspace::Workspace(gpu::FrameSource& frames, QObject* parent)
    : QObject(parent)
    , m_frames(frames)
    , m_viewSteps(new ViewSteps(*this))
    , m_pieces(new Pieces(*this))
    , m_seeds(new PendingSeeds(*this))
    , m_refinement(new Refinement(*this))
    , m_plane(new CuttingPlane(*this))
    , m_chunks(new Chunks(*this))
    , m_layerLooks(new LayerLooks(*this))
{
    m_retry.setInterval(std::chrono::seconds(5));
    connect(&m_retry, &QTimer::timeout, this, [this] {
        if (m_session)
            m_session->storage().retryWriting();
    });
}

Workspace::~Workspace() = default;

const core::Volume* Workspace::volume() const
{
    if (!m_session || m_session->document().volumes.empty())
        return nullptr;
    return &m_session->document().volumes.front();
}

void Workspace::setSession(std::unique_ptr<core::EditSession> session)
{
    if (m_tool)
        m_tool->putAway();
    if (m_session) {
        Q_EMIT sessionClosing();
        m_session->setListener({});
        m_session->setErrorListener({});
    }
    m_retry.stop();
    m_session = std::move(session);
    if (m_session) {
        m_session->setListener([this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Disk)
                followDisk();
            else if (change.what == core::DocumentChange::What::Layers)
                followLayers();
            else if (change.what == core::DocumentChange::What::History)
                followOpacities();
            Q_EMIT documentChanged(change);
        });
        m_session->setErrorListener([this](const core::Error& error) {
            if (error.code == core::ErrorCode::SessionMoved)
                noteSaved({}, error.arguments.value(0));
            fail(error);
        });
        m_session->setOrigin([] { return core::presentOrigin(authorName()); });
        applyHistoryMemory();
    }
    m_cautionAccepted = false;
    m_warnAfter.reset();
    m_pointedLps.reset();
    m_atTolerance.reset();
    m_editable = {};
    // A box is a place in a study, which would bound growth in the next one, too.
    GrowSettings growth = m_grow;
    growth.boxed = false;
    growth.box.reset();
    const bool hadBox = growth != std::exchange(m_grow, growth);
    m_measured.clear();
    m_activeSegment = 0;
    m_activeLayer = 0;
    m_opacities.clear();
    m_lostOpacities.clear();
    if (const core::Volume* opened = volume()) {
        const core::VolumeGeometry& geometry = opened->geometry;
        m_crosshairLps = initialCrosshairLps(geometry);
        m_windowLevel = opened->defaultWindow;
        m_volumeDisplay = initialVolumeDisplay(*opened);
        m_clip = core::wholeVolume(geometry);
        m_viewOptions.inverted = opened->displayInverted;
        m_viewOptions.colours = gpu::ColourMap::Grey;
        if (!m_session->document().segments.empty())
            m_activeSegment = m_session->document().segments.front().label;
        if (!m_session->document().layers.empty())
            m_activeLayer = m_session->document().layers.front().id;
    }
    Q_EMIT sessionChanged();
    Q_EMIT crosshairChanged();
    Q_EMIT windowLevelChanged();
    Q_EMIT volumeDisplayChanged();
    Q_EMIT clipChanged();
    if (hadBox)
        Q_EMIT growSettingsChanged();
    Q_EMIT editableChanged();
    Q_EMIT viewOptionsChanged();
    Q_EMIT activeSegmentChanged();
    Q_EMIT activeLayerChanged();
    Q_EMIT cautionAcceptedChanged();
    if (m_session && m_session->storage().trouble() && !m_session->storage().whyNoFile()) {
        fail({core::ErrorCode::SessionUnwritten, m_session->storage().trouble()->arguments});
        followDisk();
    }
}

const core::Measured* Workspace::measured(const core::Measurement& measurement) const
{
    const auto found = m_measured.find(measurement.id);
    return found != m_measured.end() && found->second.measurement == measurement ? &found->second
                                                                                 : nullptr;
}

void Workspace::setMeasured(const core::Measured& measured)
{
    m_measured[measured.measurement.id] = measured;
    Q_EMIT measuredChanged();
}

std::optional<core::Error> Workspace::dropSession()
{
    m_retry.stop();
    std::optional<core::Error> lost;
    if (m_session) {
        m_session->endUnheard();
        lost = m_session->storage().trouble();
    }
    m_session.reset();
    return lost;
}

void Workspace::applyHistoryMemory()
{
    if (m_session)
        m_session->storage().setStepMemory(std::size_t(historyMebibytes()) << 20);
}

void Workspace::followDisk()
{
    const bool troubled = m_session->storage().trouble().has_value();
    if (!troubled && m_retry.isActive() && !m_session->storage().whyNoFile())
        say(tr("Everything is on disk again."));
    if (troubled)
        m_retry.start();
    else
        m_retry.stop();
}

void Workspace::setCrosshairLps(const glm::dvec3& position)
{
    if (position == m_crosshairLps)
        return;
    m_crosshairLps = position;
    Q_EMIT crosshairChanged();
}

void Workspace::setWindowLevel(const core::WindowLevel& window)
{
    if (window == m_windowLevel)
        return;
    m_windowLevel = window;
    Q_EMIT windowLevelChanged();
}

void Workspace::setActiveSegment(int label)
{
    if (label == m_activeSegment)
        return;
    m_activeSegment = label;
    Q_EMIT activeSegmentChanged();
}

void Workspace::setActiveLayer(int id)
{
    if (id == m_activeLayer)
        return;
    m_activeLayer = id;
    Q_EMIT activeLayerChanged();
}

/// A layer that undo has taken away is carved no more. (One that is about to come is not there
/// yet.)
void Workspace::followLayers()
{
    const core::Document document = m_session->foreseenDocument();
    if (!document.layer(m_activeLayer) && !document.layers.empty())
        setActiveLayer(document.layers.front().id);
}

Workspace::GreyWindow Workspace::greyWindow(gpu::RenderMode mode)
{
    switch (mode) {
    case gpu::RenderMode::Mip:
        return &VolumeDisplay::mipWindow;
    case gpu::RenderMode::Xray:
        return &VolumeDisplay::xrayWindow;
    case gpu::RenderMode::Surface:
    case gpu::RenderMode::Dvr:
        break;
    }
    return nullptr;
}

void Workspace::setVolumeDisplay(const VolumeDisplay& display)
{
    if (display == m_volumeDisplay)
        return;
    m_volumeDisplay = display;
    Q_EMIT volumeDisplayChanged();
}

void Workspace::setClip(const core::ClipRegion& clip)
{
    if (clip == m_clip)
        return;
    m_clip = clip;
    Q_EMIT clipChanged();
    if (m_editable.boxed)
        Q_EMIT editableChanged();
}

Workspace::DrawnSegments Workspace::drawnSegments(const SegmentLook& look) const
{
    return {look.drawing.value_or(m_viewOptions.segmentDrawing),
        look.fillPercent.value_or(m_viewOptions.segmentFillPercent)};
}

namespace {

/// With the segments that a preview would make: their voxels are seen already.
core::Document documentSeen(const core::EditSession& session)
{
    core::Document seen = session.document();
    if (session.isOpen<core::SplitIslands>() || session.isOpen<core::SplitSegment>())
        static_cast<void>(core::applyToDocument(*session.openEdit(), seen));
    return seen;
}

} // namespace

gpu::SegmentDisplay Workspace::segmentDisplay(const SegmentLook& look) const
{
    if (!m_session)
        return {};
    gpu::SegmentDisplay display =
        ui::segmentDisplay(documentSeen(*m_session), m_viewOptions.showSegments);
    display.warningRgb = theme::caution.rgb() & 0xFFFFFFu;
    if (m_warnAfter)
        display.warnAfterGeneration = *m_warnAfter;
    display.atTolerance = m_atTolerance;
    display.growthPlane = growthPlane();
    display.showBarriers = m_viewOptions.showBarriers;
    const DrawnSegments drawn = drawnSegments(look);
    if (drawn.drawing == SegmentDrawing::Fill)
        display.outlineWidthPixels = 0.0f;
    display.fillOpacity =
        drawn.drawing == SegmentDrawing::Outline ? 0.0f : float(drawn.fillPercent) / 100.0f;
    display.voxelTrue = m_viewOptions.voxelTrueSegments;
    display.suspendedBodies = m_viewOptions.suspendedBodies;
    for (const auto& [label, percent] : m_opacities)
        display.transparencyPercent[std::size_t(label)] = std::uint8_t(100 - percent);
    return display;
}

std::uint8_t Workspace::growthPlane() const
{
    const core::Segment* active =
        m_session ? m_session->document().segment(m_activeSegment) : nullptr;
    return active ? active->plane : std::uint8_t(0);
}

void Workspace::setWarnAfter(std::optional<std::uint32_t> generation)
{
    if (generation == m_warnAfter)
        return;
    m_warnAfter = generation;
    Q_EMIT viewOptionsChanged();
}

void Workspace::setAtTolerance(const std::optional<gpu::ToleranceDisplay>& shown)
{
    if (shown == m_atTolerance)
        return;
    m_atTolerance = shown;
    Q_EMIT atToleranceChanged();
}

void Workspace::setDrillSettings(const DrillSettings& settings)
{
    if (settings == m_drill)
        return;
    m_drill = settings;
    Q_EMIT drillSettingsChanged();
}

const Workspace::BrushSettings& Workspace::brushSettings(Brush brush) const
{
    return brush == Brush::Paint ? m_paint : brush == Brush::Carve ? m_carve : m_barrier;
}

void Workspace::setBrushSettings(Brush brush, const BrushSettings& settings)
{
    BrushSettings& mine = brush == Brush::Paint ? m_paint
        : brush == Brush::Carve                 ? m_carve
                                                : m_barrier;
    if (settings == mine)
        return;
    mine = settings;
    Q_EMIT brushSettingsChanged();
}

void Workspace::setGrowSettings(const GrowSettings& settings)
{
    if (settings == m_grow)
        return;
    m_grow = settings;
    Q_EMIT growSettingsChanged();
    if (m_editable.boxed)
        Q_EMIT editableChanged();
}

void Workspace::setEditableSettings(const EditableSettings& settings)
{
    if (settings == m_editable)
        return;
    // The first stroke that keeps to it need not wait until the engine has compiled for it.
    if (settings.on && !m_editable.on && m_session)
        m_session->expectEditableRanges();
    m_editable = settings;
    Q_EMIT editableChanged();
}

std::optional<EditableBox> Workspace::editableBox() const
{
    const core::Volume* opened = volume();
    if (!opened)
        return std::nullopt;
    if (m_clip.box.on)
        return EditableBox{.box = growBoxFrom(m_clip.box, opened->geometry), .isClip = true};
    if (growBoxOf(m_grow, opened->geometry))
        return EditableBox{.box = *m_grow.box, .isClip = false};
    return std::nullopt;
}

std::optional<core::EditableRange> Workspace::editableRange() const
{
    if (!m_session || !m_editable.on)
        return std::nullopt;
    return ui::editableRange(m_editable, m_session->foreseenDocument(), editableBox());
}

QString Workspace::editableText() const
{
    return m_session ? ui::editableText(m_editable, m_session->document(), editableBox())
                     : QString();
}

void Workspace::setViewOptions(const ViewOptions& options)
{
    if (options == m_viewOptions)
        return;
    m_viewOptions = options;
    Q_EMIT viewOptionsChanged();
}

void Workspace::setSegmentOpacities(const std::map<int, int>& percents)
{
    std::map<int, int> opacities;
    for (const auto& [label, percent] : percents) {
        if (label > 0 && label < 256 && percent < 100)
            opacities[label] = std::max(percent, leastSegmentOpacity);
    }
    if (opacities == m_opacities)
        return;
    m_opacities = std::move(opacities);
    Q_EMIT viewOptionsChanged();
}

/// What a segment that has gone had is kept for its return, and not given to another one.
void Workspace::followOpacities()
{
    const core::Document& document = m_session->document();
    const core::History& history = m_session->history();
    std::map<int, int> opacities;
    for (const auto& [label, percent] : m_opacities) {
        if (document.segment(label))
            opacities[label] = percent;
        else
            m_lostOpacities[label] = {.percent = percent};
    }
    for (auto lost = m_lostOpacities.begin(); lost != m_lostOpacities.end();) {
        std::optional<std::int64_t>& rowsWhenFree = lost->second.rowsWhenFree;
        if (document.segment(lost->first)) {
            if (!rowsWhenFree || history.position() <= *rowsWhenFree)
                opacities.emplace(lost->first, lost->second.percent);
            lost = m_lostOpacities.erase(lost);
            continue;
        }
        if (!rowsWhenFree && lost->first > document.lastLabelGiven())
            rowsWhenFree = std::int64_t(history.rows().size());
        ++lost;
    }
    setSegmentOpacities(opacities);
}

int Workspace::segmentOpacity(int label) const
{
    const auto found = m_opacities.find(label);
    return found == m_opacities.end() ? 100 : found->second;
}

void Workspace::setSegmentOpacity(int label, int percent)
{
    std::map<int, int> opacities = m_opacities;
    opacities[label] = percent;
    setSegmentOpacities(opacities);
}

void Workspace::acceptCaution()
{
    if (m_cautionAccepted)
        return;
    m_cautionAccepted = true;
    Q_EMIT cautionAcceptedChanged();
}

void Workspace::setPointedLps(const std::optional<glm::dvec3>& position)
{
    if (position == m_pointedLps)
        return;
    m_pointedLps = position;
    Q_EMIT pointedLpsChanged();
}

void Workspace::setActiveTool(Tool* tool)
{
    if (tool == m_tool)
        return;
    if (m_tool) {
        disconnect(m_tool, &QObject::destroyed, this, nullptr);
        m_tool->putAway();
    }
    m_tool = tool;
    // The menus ask it at any time.
    if (m_tool)
        connect(m_tool, &QObject::destroyed, this, [this] { m_tool = nullptr; });
    if (m_tool && m_tool != m_lastTools[0])
        m_lastTools = {m_tool, m_lastTools[0]};
    Q_EMIT activeToolChanged();
}

bool Workspace::takeToolBefore()
{
    Tool* before = m_lastTools[m_tool ? 1 : 0];
    if (before)
        setActiveTool(before);
    return before != nullptr;
}

} // namespace ui
