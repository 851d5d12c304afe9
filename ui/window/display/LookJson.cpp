// SPDX-License-Identifier: Apache-2.0
#include "ui/window/display/LookJson.h"

#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Pieces.h"

#include <QColor>
#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ui::displayJson {

namespace {

constexpr std::array<const char*, gpu::renderModes> modeNames{
    "surface", "dvr", "mip", "xray"}; ///< gpu::RenderMode
constexpr std::array<const char*, 2> faceNames{"material", "grey"}; ///< gpu::CutFaces
constexpr std::array<const char*, 4> contextNames{
    "opaque", "translucent", "cutAway", "hidden"}; ///< gpu::Context

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

void readPlane(const QJsonValue& json, core::ClipPlane& plane)
{
    core::ClipPlane read = plane;
    displayJson::read(json[QLatin1String("pointLps")], read.pointLps);
    displayJson::read(json[QLatin1String("normalLps")], read.normalLps);
    displayJson::read(json[QLatin1String("on")], read.on);
    if (std::abs(glm::length(read.normalLps) - 1.0) < 1e-6)
        plane = read;
}

} // namespace

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
        readPlane(planes[qsizetype(i)], clip.planes[i]);
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

QJsonArray opacitiesToJson(const std::map<int, int>& opacities)
{
    QJsonArray list;
    for (const auto& [label, percent] : opacities)
        list.append(QJsonObject{
            {QStringLiteral("segment"), label}, {QStringLiteral("opacityPercent"), percent}});
    return list;
}

std::map<int, int> opacitiesFrom(const QJsonValue& json)
{
    std::map<int, int> opacities;
    for (const QJsonValue& entry : json.toArray())
        opacities[entry[QLatin1String("segment")].toInt()] =
            entry[QLatin1String("opacityPercent")].toInt(100);
    return opacities;
}

} // namespace ui::displayJson
