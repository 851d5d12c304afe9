// SPDX-License-Identifier: Apache-2.0
#include "ui/window/display/DisplayState.h"

#include "core/session/SessionDisplay.h"
#include "ui/input/Tool.h"
#include "ui/views/ContextSwitch.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/display/LookJson.h"
#include "ui/window/display/ToolSettings.h"
#include "ui/window/display/ViewJson.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Pieces.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

namespace ui {

namespace {

using displayJson::apply;
using displayJson::coloursNamed;
using displayJson::contextNamed;
using displayJson::interpolationNamed;
using displayJson::nameOf;
using displayJson::opacitiesFrom;
using displayJson::opacitiesToJson;
using displayJson::read;
using displayJson::segmentLookFrom;
using displayJson::slabNamed;
using displayJson::toJson;

ContextSwitch& contextSwitch(const ViewGrid& views)
{
    return *views.volume().findChild<ContextSwitch*>();
}

struct NamedView {
    const char* name;
    ImageView* view;
};

std::array<NamedView, 5> namedViews(const ViewGrid& views)
{
    return {{{"axial", &views.axial()}, {"sagittal", &views.sagittal()},
        {"coronal", &views.coronal()}, {"volume", &views.volume()}, {"plane", &views.plane()}}};
}

} // namespace

DisplayState::DisplayState(
    Workspace& workspace, ViewGrid& views, std::vector<Tool*> tools, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_views(views)
    , m_tools(std::move(tools))
{
    // Looked at now and then instead of told of each change: no change can be forgotten, and none
    // costs anything while it happens.
    m_timer.setInterval(std::chrono::seconds(3));
    connect(&m_timer, &QTimer::timeout, this, &DisplayState::keep);
    connect(&workspace, &Workspace::sessionChanged, this, &DisplayState::open);
    connect(&workspace, &Workspace::sessionClosing, this, &DisplayState::keep);
    open();
}

void DisplayState::open()
{
    if (!m_workspace.volume())
        return m_timer.stop();
    apply(m_workspace.session()->display().kept());
    m_known = composed();
    m_timer.start();
}

void DisplayState::keep()
{
    core::EditSession* session = m_workspace.session();
    const QJsonObject now = composed();
    if (!session || now == m_known)
        return;
    m_known = now;
    // Fields of a later Burin stay.
    QJsonObject kept = session->display().kept();
    for (auto field = now.constBegin(); field != now.constEnd(); ++field)
        kept[field.key()] = field.value();
    session->display().keep(kept);
}

QJsonObject DisplayState::composed() const
{
    const Workspace::ViewOptions& options = m_workspace.viewOptions();
    const Tool* tool = m_workspace.activeTool();
    QJsonObject volume = toJson(m_workspace.volumeDisplay());
    volume[QStringLiteral("contextBefore")] = nameOf(contextSwitch(m_views).before());
    QJsonObject object{{QStringLiteral("crosshairLps"), toJson(m_workspace.crosshairLps())},
        {QStringLiteral("window"), toJson(m_workspace.windowLevel())},
        {QStringLiteral("inverted"), options.inverted},
        {QStringLiteral("showCrosshair"), options.showCrosshair},
        {QStringLiteral("showPatient"), options.showPatient},
        {QStringLiteral("showSegments"), options.showSegments},
        {QStringLiteral("showCarved"), options.showCarved},
        {QStringLiteral("carvedAsHole"), options.carvedAsHole},
        {QStringLiteral("showBarriers"), options.showBarriers}, {QStringLiteral("volume"), volume},
        {QStringLiteral("clip"), toJson(m_workspace.clip())},
        {QStringLiteral("plane"), toJson(m_workspace.plane())},
        {QStringLiteral("pieces"), toJson(m_workspace.pieces().looks())},
        {QStringLiteral("layers"), toJson(m_workspace.layerLooks().looks())},
        {QStringLiteral("views"), composedViews()},
        {QStringLiteral("activeSegment"), m_workspace.activeSegment()},
        {QStringLiteral("activeLayer"), m_workspace.activeLayer()},
        {QStringLiteral("tool"), tool ? tool->iconName() : QString()}};
    const QJsonObject settings = toolSettings(m_workspace, m_tools);
    for (auto field = settings.constBegin(); field != settings.constEnd(); ++field)
        object[field.key()] = field.value();
    return object;
}

QJsonObject DisplayState::composedViews() const
{
    QJsonObject object{{QStringLiteral("volume"), toJson(m_views.volume())}};
    if (m_views.arrangement() == ViewGrid::Layout::PenAndStage)
        object[QStringLiteral("layout")] = QStringLiteral("penAndStage");
    // Only where there is one, so that states without are as they always were.
    const Workspace::ViewOptions& options = m_workspace.viewOptions();
    if (options.slabMode != gpu::SlabMode::Off)
        object[QStringLiteral("slab")] =
            QJsonObject{{QStringLiteral("mode"), nameOf(options.slabMode)},
                {QStringLiteral("mm"), options.slabMm}};
    if (options.colours != gpu::ColourMap::Grey)
        object[QStringLiteral("colours")] = nameOf(options.colours);
    if (options.interpolation)
        object[QStringLiteral("interpolation")] = nameOf(*options.interpolation);
    if (!m_workspace.segmentOpacities().empty())
        object[QStringLiteral("segments")] = opacitiesToJson(m_workspace.segmentOpacities());
    if (options.suspendedBodies)
        object[QStringLiteral("suspended")] = true;
    if (options.referenceLines)
        object[QStringLiteral("referenceLines")] = true;
    if (options.linkedPlaces)
        object[QStringLiteral("linkedPlaces")] = true;
    if (!m_views.planes().alongPatient())
        object[QStringLiteral("oblique")] = toJson(m_views.planes());
    QJsonObject turned;
    QJsonObject looks;
    for (const auto& [name, view] : namedViews(m_views)) {
        if (view == m_views.maximised())
            object[QStringLiteral("alone")] = QLatin1String(name);
        const auto* slice = qobject_cast<const SliceView*>(view);
        const auto place = slice ? slice->place() : std::nullopt;
        if (place)
            object[QLatin1String(name)] = toJson(*place);
        if (slice && !slice->turn().isUpright())
            turned[QLatin1String(name)] = toJson(slice->turn());
        if (slice && !slice->segmentLook().isUsual())
            looks[QLatin1String(name)] = toJson(slice->segmentLook());
    }
    if (!looks.isEmpty())
        object[QStringLiteral("segmentLooks")] = looks;
    if (!turned.isEmpty())
        object[QStringLiteral("turned")] = turned;
    return object;
}

void DisplayState::apply(const QJsonObject& state)
{
    if (state.isEmpty())
        return;
    applyShown(state);
    core::ClipRegion clip = m_workspace.clip();
    read(state[QLatin1String("clip")], core::wholeVolume(m_workspace.volume()->geometry), clip);
    m_workspace.setClip(clip);
    ui::apply(state[QLatin1String("plane")], m_workspace.plane());
    ui::apply(state[QLatin1String("pieces")], m_workspace.pieces());
    ui::apply(state[QLatin1String("layers")], m_workspace.layerLooks());
    m_workspace.setSegmentOpacities(
        opacitiesFrom(state[QLatin1String("views")][QLatin1String("segments")]));
    applyTools(state);
    applyViews(state[QLatin1String("views")].toObject());
}

void DisplayState::applyLook(const QJsonObject& state)
{
    applyShown(state);
    // What the state does not name is as at first, and not as the session had it.
    m_views.planes().reset();
    for (const NamedView& each : namedViews(m_views)) {
        if (auto* slice = qobject_cast<SliceView*>(each.view))
            slice->resetView();
    }
    applyViews(state[QLatin1String("views")].toObject());
}

void DisplayState::applyShown(const QJsonObject& state)
{
    glm::dvec3 crosshair = m_workspace.crosshairLps();
    read(state[QLatin1String("crosshairLps")], crosshair);
    m_workspace.setCrosshairLps(crosshair);
    core::WindowLevel window = m_workspace.windowLevel();
    read(state[QLatin1String("window")], window);
    m_workspace.setWindowLevel(window);
    Workspace::ViewOptions options = m_workspace.viewOptions();
    read(state[QLatin1String("inverted")], options.inverted);
    read(state[QLatin1String("showCrosshair")], options.showCrosshair);
    read(state[QLatin1String("showPatient")], options.showPatient);
    read(state[QLatin1String("showSegments")], options.showSegments);
    read(state[QLatin1String("showCarved")], options.showCarved);
    read(state[QLatin1String("carvedAsHole")], options.carvedAsHole);
    read(state[QLatin1String("showBarriers")], options.showBarriers);
    const QJsonValue views = state[QLatin1String("views")];
    options.suspendedBodies = views[QLatin1String("suspended")].toBool();
    options.referenceLines = views[QLatin1String("referenceLines")].toBool();
    options.linkedPlaces = views[QLatin1String("linkedPlaces")].toBool();
    options.colours = coloursNamed(views[QLatin1String("colours")].toString());
    options.interpolation = interpolationNamed(views[QLatin1String("interpolation")].toString());
    const QJsonValue slab = views[QLatin1String("slab")];
    options.slabMode = slabNamed(slab[QLatin1String("mode")].toString());
    read(slab[QLatin1String("mm")], options.slabMm, 0.001, 1000.0);
    m_workspace.setViewOptions(options);
    Workspace::VolumeDisplay volume = m_workspace.volumeDisplay();
    read(state[QLatin1String("volume")], volume);
    m_workspace.setVolumeDisplay(volume);
    const QJsonValue before = state[QLatin1String("volume")][QLatin1String("contextBefore")];
    if (before.isString())
        contextSwitch(m_views).setBefore(contextNamed(before.toString()));
}

void DisplayState::applyTools(const QJsonObject& state)
{
    const int segment = state[QLatin1String("activeSegment")].toInt();
    if (m_workspace.session()->document().segment(segment))
        m_workspace.setActiveSegment(segment);
    const int layer = state[QLatin1String("activeLayer")].toInt();
    if (m_workspace.session()->document().layer(layer))
        m_workspace.setActiveLayer(layer);

    applyToolSettings(state, m_workspace, m_tools);
    const QString name = state[QLatin1String("tool")].toString();
    const auto tool = std::find_if(m_tools.begin(), m_tools.end(),
        [&name](const Tool* each) { return each->iconName() == name; });
    m_workspace.setActiveTool(tool == m_tools.end() ? nullptr : *tool);
}

void DisplayState::applyViews(const QJsonObject& state)
{
    ui::apply(state[QLatin1String("oblique")], m_views.planes());
    ImageView* alone = nullptr;
    for (const auto& [name, view] : namedViews(m_views)) {
        if (auto* slice = qobject_cast<SliceView*>(view)) {
            ui::apply(state[QLatin1String(name)], *slice);
            SliceTurn turn = slice->turn();
            read(state[QLatin1String("turned")][QLatin1String(name)], turn);
            slice->setTurn(turn);
            slice->setSegmentLook(
                segmentLookFrom(state[QLatin1String("segmentLooks")][QLatin1String(name)]));
        }
        if (state[QLatin1String("alone")].toString() == QLatin1String(name))
            alone = view;
    }
    ui::apply(state[QLatin1String("volume")], m_views.volume());
    const bool penAndStage =
        state[QLatin1String("layout")].toString() == QLatin1String("penAndStage");
    const auto layout = penAndStage ? ViewGrid::Layout::PenAndStage : ViewGrid::Layout::Four;
    if (layout != m_views.arrangement())
        m_views.arrange(layout);
    if (alone != m_views.maximised())
        m_views.maximise(alone);
}

} // namespace ui
