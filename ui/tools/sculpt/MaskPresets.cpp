// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/MaskPresets.h"

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

QJsonObject toJson(const MaskPreset& preset)
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

std::optional<MaskPreset> fromJson(const QJsonObject& json)
{
    MaskPreset preset;
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
    preset.shape = core::MaskShape::Kind(shape);
    return preset;
}

} // namespace

std::vector<MaskPreset> maskPresets()
{
    const QByteArray text = QSettings().value(settingsKey).toByteArray();
    std::vector<MaskPreset> presets;
    for (const QJsonValue& each : QJsonDocument::fromJson(text).array()) {
        if (const std::optional<MaskPreset> preset = fromJson(each.toObject()))
            presets.push_back(*preset);
    }
    return presets;
}

void setMaskPresets(const std::vector<MaskPreset>& presets)
{
    QJsonArray array;
    for (const MaskPreset& preset : presets)
        array.append(toJson(preset));
    QSettings().setValue(settingsKey, QJsonDocument(array).toJson(QJsonDocument::Compact));
}

void saveMaskPreset(const MaskPreset& preset)
{
    std::vector<MaskPreset> presets = maskPresets();
    std::erase_if(presets, [&](const MaskPreset& each) { return each.name == preset.name; });
    const auto place = std::find_if(presets.begin(), presets.end(), [&](const MaskPreset& each) {
        return QString::localeAwareCompare(each.name, preset.name) > 0;
    });
    presets.insert(place, preset);
    setMaskPresets(presets);
}

void removeMaskPreset(const QString& name)
{
    std::vector<MaskPreset> presets = maskPresets();
    std::erase_if(presets, [&](const MaskPreset& each) { return each.name == name; });
    setMaskPresets(presets);
}

MaskPreset presetOf(const Workspace::DrillSettings& settings, const QString& name)
{
    return {.name = name,
        .shape = settings.shape,
        .radiusMm = settings.radiusMm,
        .heightRatio = settings.heightRatio,
        .rotationDegrees = settings.rotationDegrees,
        .softnessMm = settings.softnessMm,
        .outline = settings.freehand ? settings.outline : MaskOutline()};
}

Workspace::DrillSettings withPreset(Workspace::DrillSettings settings, const MaskPreset& preset)
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
