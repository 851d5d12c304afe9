// SPDX-License-Identifier: Apache-2.0
#include "ui/window/DisplayState.h"

#include "core/session/SessionDisplay.h"
#include "ui/base/DisplayJson.h"
#include "ui/input/Tool.h"
#include "ui/views/ContextSwitch.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/ToolSettings.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Pieces.h"

#include <QColor>
#include <QJsonArray>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace ui {

namespace {

using displayJson::read;

constexpr std::array<const char*, gpu::renderModes> modeNames{
    "surface", "dvr", "mip", "xray"}; ///< gpu::RenderMode
constexpr std::array<const char*, 2> faceNames{"material", "grey"}; ///< gpu::CutFaces
constexpr std::array<const char*, 4> contextNames{
    "opaque", "translucent", "cutAway", "hidden"}; ///< gpu::Context

constexpr std::array<const char*, 4> slabNames{"off", "mip", "minip", "mean"}; ///< gpu::SlabMode

// --- Plain values. Reading leaves the target alone where there is nothing sensible. --------------

QJsonArray toJson(const glm::dvec3& point)
{
    return {point.x, point.y, point.z};
}

QJsonObject toJson(const core::WindowLevel& window)
{
    return {{QStringLiteral("centre"), window.centre}, {QStringLiteral("width"), window.width}};
}

void read(const QJsonValue& json, glm::dvec3& point)
{
    if (json.toArray().size() != 3)
        return;
    for (int axis = 0; axis < 3; ++axis)
        read(json.toArray().at(axis), point[axis]);
}

void read(const QJsonValue& json, core::WindowLevel& window)
{
    read(json[QLatin1String("centre")], window.centre);
    if (json[QLatin1String("width")].toDouble() > 0.0)
        read(json[QLatin1String("width")], window.width);
}

// --- The 3D view's look. -------------------------------------------------------------------------

QJsonArray toJson(const gpu::TransferFunction& function)
{
    QJsonArray points;
    for (const gpu::TransferFunction::Point& point : function.points)
        points.append(QJsonObject{{QStringLiteral("value"), point.value},
            {QStringLiteral("color"), QColor(QRgb(point.rgb)).name()},
            {QStringLiteral("opacity"), point.opacity}});
    return points;
}

void read(const QJsonValue& json, gpu::TransferFunction& function)
{
    gpu::TransferFunction read;
    for (const QJsonValue& entry : json.toArray()) {
        const QColor colour(entry[QLatin1String("color")].toString());
        const double opacity = entry[QLatin1String("opacity")].toDouble(-1.0);
        if (!colour.isValid() || !entry[QLatin1String("value")].isDouble() || opacity < 0.0
            || opacity > 1.0)
            return;
        read.points.push_back({.value = entry[QLatin1String("value")].toDouble(),
            .rgb = colour.rgb() & 0xFFFFFFU,
            .opacity = opacity});
    }
    const bool ascending = std::is_sorted(read.points.begin(), read.points.end(),
        [](const auto& a, const auto& b) { return a.value < b.value; });
    if (ascending && !read.points.empty())
        function = std::move(read);
}

/// Empty: none.
QString nameOf(std::optional<gpu::Context> context)
{
    return context ? QLatin1String(contextNames[std::size_t(*context)]) : QString();
}

std::optional<gpu::Context> contextNamed(const QString& name)
{
    for (std::size_t i = 0; i < contextNames.size(); ++i) {
        if (name == QLatin1String(contextNames[i]))
            return gpu::Context(i);
    }
    return std::nullopt;
}

gpu::SlabMode slabNamed(const QString& name)
{
    for (std::size_t i = 0; i < slabNames.size(); ++i) {
        if (name == QLatin1String(slabNames[i]))
            return gpu::SlabMode(i);
    }
    return gpu::SlabMode::Off;
}

QJsonObject toJson(const Workspace::VolumeDisplay& display)
{
    return {{QStringLiteral("mode"), QLatin1String(modeNames[std::size_t(display.mode)])},
        {QStringLiteral("surfaceThreshold"), display.surfaceThreshold},
        {QStringLiteral("transferFunction"), toJson(display.transferFunction)},
        {QStringLiteral("mipWindow"), toJson(display.mipWindow)},
        {QStringLiteral("xrayWindow"), toJson(display.xrayWindow)},
        {QStringLiteral("cutFaces"), QLatin1String(faceNames[std::size_t(display.cutFaces)])},
        {QStringLiteral("context"), nameOf(display.context)},
        {QStringLiteral("contextOpacity"), display.contextOpacity}};
}

void read(const QJsonValue& json, Workspace::VolumeDisplay& display)
{
    const QString mode = json[QLatin1String("mode")].toString();
    for (std::size_t i = 0; i < modeNames.size(); ++i) {
        if (mode == QLatin1String(modeNames[i]))
            display.mode = gpu::RenderMode(i);
    }
    read(json[QLatin1String("surfaceThreshold")], display.surfaceThreshold);
    read(json[QLatin1String("transferFunction")], display.transferFunction);
    read(json[QLatin1String("mipWindow")], display.mipWindow);
    read(json[QLatin1String("xrayWindow")], display.xrayWindow);
    const QString faces = json[QLatin1String("cutFaces")].toString();
    for (std::size_t i = 0; i < faceNames.size(); ++i) {
        if (faces == QLatin1String(faceNames[i]))
            display.cutFaces = gpu::CutFaces(i);
    }
    display.context =
        contextNamed(json[QLatin1String("context")].toString()).value_or(display.context);
    read(json[QLatin1String("contextOpacity")], display.contextOpacity);
    display.contextOpacity = std::clamp(display.contextOpacity, 0.0, 1.0);
}

QJsonObject toJson(const core::ClipRegion& clip)
{
    QJsonArray planes;
    for (const core::ClipPlane& plane : clip.planes)
        planes.append(QJsonObject{{QStringLiteral("pointLps"), toJson(plane.pointLps)},
            {QStringLiteral("normalLps"), toJson(plane.normalLps)},
            {QStringLiteral("on"), plane.on}});
    return {{QStringLiteral("box"),
                QJsonObject{{QStringLiteral("minimum"), toJson(clip.box.minimum)},
                    {QStringLiteral("maximum"), toJson(clip.box.maximum)},
                    {QStringLiteral("on"), clip.box.on}}},
        {QStringLiteral("planes"), planes}};
}

void read(const QJsonValue& json, core::ClipPlane& plane)
{
    core::ClipPlane read = plane;
    ui::read(json[QLatin1String("pointLps")], read.pointLps);
    ui::read(json[QLatin1String("normalLps")], read.normalLps);
    ui::read(json[QLatin1String("on")], read.on);
    if (std::abs(glm::length(read.normalLps) - 1.0) < 1e-6)
        plane = read;
}

/// @param whole the greatest box
void read(const QJsonValue& json, const core::ClipRegion& whole, core::ClipRegion& clip)
{
    const QJsonValue boxJson = json[QLatin1String("box")];
    core::ClipRegion::Box box = clip.box;
    read(boxJson[QLatin1String("minimum")], box.minimum);
    read(boxJson[QLatin1String("maximum")], box.maximum);
    read(boxJson[QLatin1String("on")], box.on);
    box.minimum = glm::max(box.minimum, whole.box.minimum);
    box.maximum = glm::min(box.maximum, whole.box.maximum);
    if (glm::all(glm::lessThan(box.minimum, box.maximum)))
        clip.box = box;
    const QJsonArray planes = json[QLatin1String("planes")].toArray();
    for (std::size_t i = 0; i < clip.planes.size() && qsizetype(i) < planes.size(); ++i)
        read(planes[qsizetype(i)], clip.planes[i]);
}

QJsonObject toJson(const CuttingPlane& plane)
{
    return {{QStringLiteral("centreLps"), toJson(plane.pose().centreLps)},
        {QStringLiteral("rightLps"), toJson(plane.pose().rightLps)},
        {QStringLiteral("downLps"), toJson(plane.pose().downLps)},
        {QStringLiteral("shown"), plane.look().shown},
        {QStringLiteral("opacity"), plane.look().opacity},
        {QStringLiteral("clipsAbove"), plane.look().clipsAbove}};
}

bool atRightAngles(const glm::dvec3& a, const glm::dvec3& b)
{
    constexpr double tolerance = 1e-6;
    return std::abs(glm::length(a) - 1.0) < tolerance && std::abs(glm::length(b) - 1.0) < tolerance
        && std::abs(glm::dot(a, b)) < tolerance;
}

void apply(const QJsonValue& json, CuttingPlane& plane)
{
    CuttingPlane::Pose pose = plane.pose();
    read(json[QLatin1String("centreLps")], pose.centreLps);
    read(json[QLatin1String("rightLps")], pose.rightLps);
    read(json[QLatin1String("downLps")], pose.downLps);
    if (atRightAngles(pose.rightLps, pose.downLps))
        plane.setPose(pose);
    CuttingPlane::Look look = plane.look();
    double opacity = look.opacity;
    read(json[QLatin1String("shown")], look.shown);
    read(json[QLatin1String("opacity")], opacity);
    read(json[QLatin1String("clipsAbove")], look.clipsAbove);
    look.opacity = float(std::clamp(opacity, 0.0, 1.0));
    plane.setLook(look);
}

QJsonArray toJson(const std::map<int, PieceLook>& looks)
{
    QJsonArray list;
    for (const auto& [piece, look] : looks) {
        if (look == PieceLook())
            continue;
        QJsonObject entry{{QStringLiteral("piece"), piece},
            {QStringLiteral("visible"), look.visible}, {QStringLiteral("opacity"), look.opacity},
            {QStringLiteral("tissue"), look.tissue}};
        if (look.rgb)
            entry[QStringLiteral("color")] = QColor(QRgb(*look.rgb)).name();
        if (!look.map.points.empty())
            entry[QStringLiteral("transferFunction")] = toJson(look.map);
        list.append(entry);
    }
    return list;
}

void apply(const QJsonValue& json, Pieces& pieces)
{
    for (const QJsonValue& entry : json.toArray()) {
        PieceLook look;
        read(entry[QLatin1String("visible")], look.visible);
        read(entry[QLatin1String("opacity")], look.opacity);
        read(entry[QLatin1String("tissue")], look.tissue);
        read(entry[QLatin1String("transferFunction")], look.map);
        look.opacity = std::clamp(look.opacity, 0.05, 1.0);
        const QColor colour(entry[QLatin1String("color")].toString());
        if (colour.isValid())
            look.rgb = colour.rgb() & 0xFFFFFFU;
        pieces.setLook(entry[QLatin1String("piece")].toInt(), look);
    }
}

QJsonArray toJson(const std::map<int, LayerLook>& looks)
{
    QJsonArray list;
    for (const auto& [layer, look] : looks) {
        if (look != LayerLook())
            list.append(
                QJsonObject{{QStringLiteral("layer"), layer}, {QStringLiteral("hides"), look.hides},
                    {QStringLiteral("softness"), look.softness}});
    }
    return list;
}

void apply(const QJsonValue& json, LayerLooks& layers)
{
    for (const QJsonValue& entry : json.toArray()) {
        LayerLook look;
        read(entry[QLatin1String("hides")], look.hides);
        read(entry[QLatin1String("softness")], look.softness);
        look.hides = std::clamp(look.hides, 0.0, 1.0);
        look.softness = std::clamp(look.softness, 0.0, 1.0);
        layers.setLook(entry[QLatin1String("layer")].toInt(), look);
    }
}

// --- Where the views stand. ----------------------------------------------------------------------

QJsonObject toJson(const SliceView::Place& place)
{
    return {{QStringLiteral("centreLps"), toJson(place.centreLps)},
        {QStringLiteral("mmPerPixel"), place.mmPerPixel}};
}

void apply(const QJsonValue& json, SliceView& view)
{
    SliceView::Place place{.mmPerPixel = 0.0};
    read(json[QLatin1String("centreLps")], place.centreLps);
    read(json[QLatin1String("mmPerPixel")], place.mmPerPixel);
    if (place.mmPerPixel > 0.0)
        view.setPlace(place);
}

QJsonObject toJson(const VolumeView& view)
{
    const Camera& camera = view.camera();
    QJsonObject object{{QStringLiteral("towardsViewer"), toJson(camera.towardsViewer)},
        {QStringLiteral("up"), toJson(camera.up)}};
    // A view that shows everything does so in a window of another size as well.
    if (!view.fitted()) {
        object[QStringLiteral("targetLps")] = toJson(camera.targetLps);
        object[QStringLiteral("heightMm")] = camera.heightMm;
    }
    return object;
}

void apply(const QJsonValue& json, VolumeView& view)
{
    if (!json.isObject())
        return;
    Camera camera = view.camera();
    read(json[QLatin1String("towardsViewer")], camera.towardsViewer);
    read(json[QLatin1String("up")], camera.up);
    if (!atRightAngles(camera.up, camera.towardsViewer))
        return;
    if (json[QLatin1String("heightMm")].toDouble() <= 0.0)
        return view.fitCamera(camera);
    read(json[QLatin1String("targetLps")], camera.targetLps);
    read(json[QLatin1String("heightMm")], camera.heightMm);
    view.setCamera(camera);
}

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
        object[QStringLiteral("slab")] = QJsonObject{
            {QStringLiteral("mode"), QLatin1String(slabNames[std::size_t(options.slabMode)])},
            {QStringLiteral("mm"), options.slabMm}};
    for (const auto& [name, view] : namedViews(m_views)) {
        if (view == m_views.maximised())
            object[QStringLiteral("alone")] = QLatin1String(name);
        const auto* slice = qobject_cast<const SliceView*>(view);
        const auto place = slice ? slice->place() : std::nullopt;
        if (place)
            object[QLatin1String(name)] = toJson(*place);
    }
    return object;
}

void DisplayState::apply(const QJsonObject& state)
{
    if (state.isEmpty())
        return;
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
    const QJsonValue slab = state[QLatin1String("views")][QLatin1String("slab")];
    options.slabMode = slabNamed(slab[QLatin1String("mode")].toString());
    read(slab[QLatin1String("mm")], options.slabMm, 0.001, 1000.0);
    m_workspace.setViewOptions(options);
    Workspace::VolumeDisplay volume = m_workspace.volumeDisplay();
    read(state[QLatin1String("volume")], volume);
    m_workspace.setVolumeDisplay(volume);
    const QJsonValue before = state[QLatin1String("volume")][QLatin1String("contextBefore")];
    if (before.isString())
        contextSwitch(m_views).setBefore(contextNamed(before.toString()));
    core::ClipRegion clip = m_workspace.clip();
    read(state[QLatin1String("clip")], core::wholeVolume(m_workspace.volume()->geometry), clip);
    m_workspace.setClip(clip);
    ui::apply(state[QLatin1String("plane")], m_workspace.plane());
    ui::apply(state[QLatin1String("pieces")], m_workspace.pieces());
    ui::apply(state[QLatin1String("layers")], m_workspace.layerLooks());
    applyTools(state);
    applyViews(state[QLatin1String("views")].toObject());
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
    ImageView* alone = nullptr;
    for (const auto& [name, view] : namedViews(m_views)) {
        if (auto* slice = qobject_cast<SliceView*>(view))
            ui::apply(state[QLatin1String(name)], *slice);
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
