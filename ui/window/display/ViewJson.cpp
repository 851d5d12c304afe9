// SPDX-License-Identifier: Apache-2.0
#include "ui/window/display/ViewJson.h"

#include "ui/views/VolumeView.h"
#include "ui/window/display/LookJson.h"

#include <array>

namespace ui::displayJson {

namespace {

constexpr std::array<const char*, 4> slabNames{"off", "mip", "minip", "mean"}; ///< gpu::SlabMode

constexpr std::array<const char*, gpu::colourMaps> colourNames{
    "grey", "hotIron", "hotMetalBlue", "pet20Step", "evenLightness"}; ///< gpu::ColourMap

constexpr std::array<const char*, gpu::interpolations> interpolationNames{
    "nearest", "linear", "cubic"}; ///< gpu::Interpolation

constexpr std::array<const char*, 3> drawingNames{
    "fillAndOutline", "fill", "outline"}; ///< Workspace::SegmentDrawing

constexpr std::array<const char*, 3> planeNames{
    "axial", "sagittal", "coronal"}; ///< in the order of MprPlanes::all

} // namespace

QString nameOf(gpu::SlabMode mode)
{
    return QLatin1String(slabNames[std::size_t(mode)]);
}

gpu::SlabMode slabNamed(const QString& name)
{
    for (std::size_t i = 0; i < slabNames.size(); ++i) {
        if (name == QLatin1String(slabNames[i]))
            return gpu::SlabMode(i);
    }
    return gpu::SlabMode::Off;
}

QString nameOf(gpu::ColourMap map)
{
    return QLatin1String(colourNames[std::size_t(map)]);
}

gpu::ColourMap coloursNamed(const QString& name)
{
    for (std::size_t i = 0; i < colourNames.size(); ++i) {
        if (name == QLatin1String(colourNames[i]))
            return gpu::ColourMap(i);
    }
    return gpu::ColourMap::Grey;
}

QString nameOf(gpu::Interpolation interpolation)
{
    return QLatin1String(interpolationNames[std::size_t(interpolation)]);
}

std::optional<gpu::Interpolation> interpolationNamed(const QString& name)
{
    for (std::size_t i = 0; i < interpolationNames.size(); ++i) {
        if (name == QLatin1String(interpolationNames[i]))
            return gpu::Interpolation(i);
    }
    return std::nullopt;
}

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

QJsonObject toJson(const MprPlanes& planes)
{
    QJsonObject object;
    for (std::size_t i = 0; i < planeNames.size(); ++i) {
        const SliceAxes& axes = planes.axes(MprPlanes::all[i]);
        object[QLatin1String(planeNames[i])] =
            QJsonObject{{QStringLiteral("rightLps"), toJson(axes.rightLps)},
                {QStringLiteral("downLps"), toJson(axes.downLps)}};
    }
    return object;
}

void apply(const QJsonValue& json, MprPlanes& planes)
{
    for (std::size_t i = 0; i < planeNames.size(); ++i) {
        SliceAxes axes = planes.axes(MprPlanes::all[i]);
        const QJsonValue plane = json[QLatin1String(planeNames[i])];
        read(plane[QLatin1String("rightLps")], axes.rightLps);
        read(plane[QLatin1String("downLps")], axes.downLps);
        if (plane.isObject() && atRightAngles(axes.rightLps, axes.downLps))
            planes.set(MprPlanes::all[i], axes.rightLps, axes.downLps);
    }
}

QJsonObject toJson(const SliceTurn& turn)
{
    return {
        {QStringLiteral("mirrored"), turn.mirrored}, {QStringLiteral("quarters"), turn.quarters}};
}

void read(const QJsonValue& json, SliceTurn& turn)
{
    const int quarters = json[QLatin1String("quarters")].toInt(-1);
    if (quarters >= 0 && quarters < 4)
        turn = {json[QLatin1String("mirrored")].toBool(), quarters};
}

QJsonObject toJson(const Workspace::SegmentLook& look)
{
    QJsonObject object;
    if (look.drawing)
        object[QStringLiteral("drawing")] = QLatin1String(drawingNames[std::size_t(*look.drawing)]);
    if (look.fillPercent)
        object[QStringLiteral("fillPercent")] = *look.fillPercent;
    return object;
}

Workspace::SegmentLook segmentLookFrom(const QJsonValue& json)
{
    Workspace::SegmentLook look;
    const QString name = json[QLatin1String("drawing")].toString();
    for (std::size_t i = 0; i < drawingNames.size(); ++i) {
        if (name == QLatin1String(drawingNames[i]))
            look.drawing = Workspace::SegmentDrawing(i);
    }
    const int percent = json[QLatin1String("fillPercent")].toInt(-1);
    if (percent >= 0 && percent <= 100)
        look.fillPercent = percent;
    return look;
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

} // namespace ui::displayJson
