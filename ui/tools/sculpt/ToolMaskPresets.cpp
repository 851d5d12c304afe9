// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/ToolMaskPresets.h"

#include "ui/tools/sculpt/DrillOptions.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ui {

namespace {

const QString settingsKey = QStringLiteral("drill/masks");
constexpr int shapes = 5;

QJsonObject toJson(const ToolMaskPreset& preset)
{
    QJsonObject json{{QStringLiteral("name"), preset.name},
        {QStringLiteral("shape"), int(preset.shape)}, {QStringLiteral("radiusMm"), preset.radiusMm},
        {QStringLiteral("heightRatio"), preset.heightRatio},
        {QStringLiteral("rotationDegrees"), preset.rotationDegrees},
        {QStringLiteral("softnessMm"), preset.softnessMm}};
    if (!preset.outline.empty())
        json[QStringLiteral("outline")] = outlineJson(preset.outline);
    return json;
}

std::optional<ToolMaskPreset> fromJson(const QJsonObject& json)
{
    ToolMaskPreset preset;
    preset.name = json[QLatin1String("name")].toString();
    const int shape = json[QLatin1String("shape")].toInt(-1);
    preset.radiusMm = json[QLatin1String("radiusMm")].toDouble(std::nan(""));
    preset.heightRatio = json[QLatin1String("heightRatio")].toDouble(std::nan(""));
    preset.rotationDegrees = json[QLatin1String("rotationDegrees")].toDouble(std::nan(""));
    preset.softnessMm = json[QLatin1String("softnessMm")].toDouble();
    preset.outline = outlineFromJson(json[QLatin1String("outline")]);
    const bool sound = !preset.name.isEmpty() && shape >= 0 && shape < shapes
        && preset.radiusMm >= DrillOptions::minimumRadiusMm
        && preset.radiusMm <= DrillOptions::maximumRadiusMm
        && preset.heightRatio >= DrillOptions::minimumHeightRatio && preset.heightRatio <= 1.0
        && std::abs(preset.rotationDegrees) <= 180.0 && preset.softnessMm >= 0.0
        && preset.softnessMm <= DrillOptions::maximumSoftnessMm
        && preset.outline.empty() != json.contains(QLatin1String("outline"));
    if (!sound)
        return std::nullopt;
    preset.shape = core::ToolMask::Kind(shape);
    return preset;
}

} // namespace

std::vector<ToolMaskPreset> toolMaskPresets()
{
    const QByteArray text = QSettings().value(settingsKey).toByteArray();
    std::vector<ToolMaskPreset> presets;
    for (const QJsonValue& each : QJsonDocument::fromJson(text).array()) {
        if (const std::optional<ToolMaskPreset> preset = fromJson(each.toObject()))
            presets.push_back(*preset);
    }
    return presets;
}

void setToolMaskPresets(const std::vector<ToolMaskPreset>& presets)
{
    QJsonArray array;
    for (const ToolMaskPreset& preset : presets)
        array.append(toJson(preset));
    QSettings().setValue(settingsKey, QJsonDocument(array).toJson(QJsonDocument::Compact));
}

void saveToolMaskPreset(const ToolMaskPreset& preset)
{
    std::vector<ToolMaskPreset> presets = toolMaskPresets();
    std::erase_if(presets, [&](const ToolMaskPreset& each) { return each.name == preset.name; });
    const auto place =
        std::find_if(presets.begin(), presets.end(), [&](const ToolMaskPreset& each) {
            return QString::localeAwareCompare(each.name, preset.name) > 0;
        });
    presets.insert(place, preset);
    setToolMaskPresets(presets);
}

void removeToolMaskPreset(const QString& name)
{
    std::vector<ToolMaskPreset> presets = toolMaskPresets();
    std::erase_if(presets, [&](const ToolMaskPreset& each) { return each.name == name; });
    setToolMaskPresets(presets);
}

ToolMaskPreset presetOf(const Workspace::DrillSettings& settings, const QString& name)
{
    return {.name = name,
        .shape = settings.shape,
        .radiusMm = settings.radiusMm,
        .heightRatio = settings.heightRatio,
        .rotationDegrees = settings.rotationDegrees,
        .softnessMm = settings.softnessMm,
        .outline = settings.freehand ? settings.outline : ToolMaskOutline()};
}

Workspace::DrillSettings withPreset(Workspace::DrillSettings settings, const ToolMaskPreset& preset)
{
    settings.shape = preset.shape;
    settings.radiusMm = preset.radiusMm;
    settings.heightRatio = preset.heightRatio;
    settings.rotationDegrees = preset.rotationDegrees;
    settings.softnessMm = preset.softnessMm;
    settings.freehand = !preset.outline.empty();
    if (settings.freehand)
        settings.outline = preset.outline;
    return settings;
}

} // namespace ui
