// SPDX-License-Identifier: Apache-2.0
#include "ui/window/display/ToolSettings.h"

#include "ui/base/DisplayJson.h"
#include "ui/input/Tool.h"
#include "ui/tools/common/BrushTool.h"
#include "ui/tools/sculpt/DrillOptions.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ui {

namespace {

using displayJson::read;

constexpr std::array<std::pair<const char*, Workspace::Brush>, 3> brushes{
    {{"paint", Workspace::Brush::Paint}, {"carve", Workspace::Brush::Carve},
        {"barrier", Workspace::Brush::Barrier}}};

QJsonObject toJson(const Workspace::DrillSettings& drill)
{
    return {{QStringLiteral("radiusMm"), drill.radiusMm},
        {QStringLiteral("depthMm"), drill.depthMm},
        {QStringLiteral("throughGaps"), drill.throughGaps},
        {QStringLiteral("shape"), int(drill.shape)},
        {QStringLiteral("heightRatio"), drill.heightRatio},
        {QStringLiteral("rotationDegrees"), drill.rotationDegrees},
        {QStringLiteral("softnessMm"), drill.softnessMm},
        {QStringLiteral("turnsWithPen"), drill.turnsWithPen},
        {QStringLiteral("foreshortened"), drill.foreshortened},
        {QStringLiteral("floorMm"), drill.floorMm},
        {QStringLiteral("pressureExponent"), drill.pressureExponent},
        {QStringLiteral("rate"), drill.mode == core::DrillMode::Rate},
        {QStringLiteral("laserDepthMm"), drill.laserDepthMm},
        {QStringLiteral("sweep"), int(drill.sweep)}, {QStringLiteral("freehand"), drill.freehand},
        {QStringLiteral("outline"), outlineJson(drill.outline)}};
}

/// An enumerator by its number. @param last the greatest
template <typename Enum> void read(const QJsonValue& json, Enum& value, Enum last)
{
    const int number = json.toInt(-1);
    if (number >= 0 && number <= int(last))
        value = Enum(number);
}

void read(const QJsonValue& json, Workspace::DrillSettings& drill)
{
    using Options = DrillOptions;
    const auto at = [&json](const char* field) { return json[QLatin1String(field)]; };
    read(at("radiusMm"), drill.radiusMm, Options::minimumRadiusMm, Options::maximumRadiusMm);
    read(at("depthMm"), drill.depthMm, Options::minimumDepthMm, Options::maximumDepthMm);
    read(at("throughGaps"), drill.throughGaps);
    read(at("shape"), drill.shape, core::ToolMask::Kind::Rounded);
    read(at("heightRatio"), drill.heightRatio, Options::minimumHeightRatio, 1.0);
    read(at("rotationDegrees"), drill.rotationDegrees, -180.0, 180.0);
    read(at("softnessMm"), drill.softnessMm, 0.0, Options::maximumSoftnessMm);
    read(at("turnsWithPen"), drill.turnsWithPen);
    read(at("foreshortened"), drill.foreshortened);
    read(at("floorMm"), drill.floorMm, Options::minimumFloorMm, Options::maximumFloorMm);
    drill.pressureExponent = std::clamp(at("pressureExponent").toInt(drill.pressureExponent), 1, 3);
    bool rate = drill.mode == core::DrillMode::Rate;
    read(at("rate"), rate);
    drill.mode = rate ? core::DrillMode::Rate : core::DrillMode::Limit;
    read(at("laserDepthMm"), drill.laserDepthMm, Options::minimumDepthMm, Options::maximumDepthMm);
    read(at("sweep"), drill.sweep, Workspace::Sweep::Pen);
    drill.outline = outlineFromJson(at("outline"));
    drill.freehand = at("freehand").toBool() && !drill.outline.empty();
}

QJsonObject toJson(const Workspace::BrushSettings& brush)
{
    return {{QStringLiteral("radiusMm"), brush.radiusMm}, {QStringLiteral("disc"), brush.disc},
        {QStringLiteral("square"), brush.square},
        {QStringLiteral("onlyBetween"), brush.onlyBetween}, {QStringLiteral("lower"), brush.lower},
        {QStringLiteral("upper"), brush.upper},
        {QStringLiteral("overwriteUnlocked"), brush.overwriteUnlocked},
        {QStringLiteral("radiusByPressure"), brush.radiusByPressure},
        {QStringLiteral("followsEdges"), brush.followsEdges},
        {QStringLiteral("edgeTolerance"), brush.edgeTolerance},
        {QStringLiteral("toleranceByPressure"), brush.toleranceByPressure}};
}

void read(const QJsonValue& json, Workspace::BrushSettings& brush)
{
    read(json[QLatin1String("radiusMm")], brush.radiusMm, BrushTool::minimumRadiusMm,
        BrushTool::maximumRadiusMm);
    read(json[QLatin1String("disc")], brush.disc);
    read(json[QLatin1String("square")], brush.square);
    read(json[QLatin1String("onlyBetween")], brush.onlyBetween);
    read(json[QLatin1String("lower")], brush.lower);
    read(json[QLatin1String("upper")], brush.upper);
    read(json[QLatin1String("overwriteUnlocked")], brush.overwriteUnlocked);
    read(json[QLatin1String("radiusByPressure")], brush.radiusByPressure);
    read(json[QLatin1String("followsEdges")], brush.followsEdges);
    read(json[QLatin1String("edgeTolerance")], brush.edgeTolerance, 0.0,
        Workspace::BrushSettings::greatestEdgeTolerance);
    read(json[QLatin1String("toleranceByPressure")], brush.toleranceByPressure);
}

/// Sessions of old have one interval for all segments, which is left as it is.
void readIntervals(const QJsonObject& state, Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return;
    SegmentIntervals& intervals = workspace.seeds().intervals();
    intervals.read(state[QLatin1String("intervals")].toArray(), *session);
    const QJsonObject old = state[QLatin1String("growth")].toObject();
    const QJsonValue lower = old[QLatin1String("lower")];
    const QJsonValue upper = old[QLatin1String("upper")];
    const bool sound = lower.isDouble() && upper.isDouble() && lower.toDouble() <= upper.toDouble();
    if (state.contains(QLatin1String("intervals")) || !sound)
        return;
    const Workspace::GrowSettings& growth = workspace.growSettings();
    for (const core::Segment& segment : session->document().segments)
        intervals.set(
            segment.label, {.lower = growth.lower, .upper = growth.upper, .byHand = true});
}

} // namespace

QJsonObject toolSettings(const Workspace& workspace, const std::vector<Tool*>& tools)
{
    QJsonObject settings{{QStringLiteral("drill"), toJson(workspace.drillSettings())},
        {QStringLiteral("growth"), growSettingsJson(workspace.growSettings())},
        {QStringLiteral("intervals"), workspace.seeds().intervals().json()}};
    for (const auto& [name, brush] : brushes)
        settings[QLatin1String(name)] = toJson(workspace.brushSettings(brush));
    QJsonObject own;
    for (const Tool* tool : tools) {
        if (const QJsonObject kept = tool->settingsJson(); !kept.isEmpty())
            own[tool->iconName()] = kept;
    }
    settings[QStringLiteral("tools")] = own;
    return settings;
}

void applyToolSettings(
    const QJsonObject& state, Workspace& workspace, const std::vector<Tool*>& tools)
{
    Workspace::DrillSettings drill = workspace.drillSettings();
    read(state[QLatin1String("drill")], drill);
    workspace.setDrillSettings(drill);
    for (const auto& [name, brush] : brushes) {
        Workspace::BrushSettings settings = workspace.brushSettings(brush);
        read(state[QLatin1String(name)], settings);
        workspace.setBrushSettings(brush, settings);
    }
    Workspace::GrowSettings growth = workspace.growSettings();
    readGrowSettings(state[QLatin1String("growth")].toObject(), growth);
    workspace.setGrowSettings(growth);
    readIntervals(state, workspace);
    const QJsonValue own = state[QLatin1String("tools")];
    for (Tool* tool : tools)
        tool->applySettings(own[tool->iconName()].toObject());
}

} // namespace ui
