// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourSettings.h"

#include "core/edits/kinds/filling/EvolveContour.h"

#include <algorithm>

namespace ui {

namespace {

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

} // namespace

void ContourSettings::changeBubble(int steps)
{
    const double step = bubbleMm < 10.0 ? 0.5 : 1.0;
    bubbleMm = std::clamp(bubbleMm + steps * step, minimumBubbleMm, maximumBubbleMm);
}

QJsonObject ContourSettings::json() const
{
    return {{QStringLiteral("fromSegment"), start == Start::Segment},
        {QStringLiteral("fromSeeds"), start == Start::Seeds},
        {QStringLiteral("fromBubbles"), start == Start::Bubbles},
        {QStringLiteral("bubbleMm"), bubbleMm},
        {QStringLiteral("radiusByPressure"), radiusByPressure},
        {QStringLiteral("valuesOfBubble"), valuesOfBubble}, {QStringLiteral("softness"), softness},
        {QStringLiteral("smoothness"), smoothness}, {QStringLiteral("edge"), edge},
        {QStringLiteral("edgeGradient"), edgeGradient},
        {QStringLiteral("generations"), generations}};
}

void ContourSettings::read(const QJsonObject& json)
{
    constexpr int whole = 100;
    // Sessions that are older than seeds as a start have the first one alone.
    const QJsonValue fromSegment = json[QLatin1String("fromSegment")];
    if (fromSegment.toBool())
        start = Start::Segment;
    else if (json[QLatin1String("fromSeeds")].toBool())
        start = Start::Seeds;
    else if (json[QLatin1String("fromBubbles")].toBool())
        start = Start::Bubbles;
    else if (fromSegment.isBool())
        start = Start::Bubble;
    readNumber(json, "bubbleMm", minimumBubbleMm, maximumBubbleMm, bubbleMm);
    radiusByPressure = json[QLatin1String("radiusByPressure")].toBool(radiusByPressure);
    valuesOfBubble = json[QLatin1String("valuesOfBubble")].toBool(valuesOfBubble);
    readWhole(json, "softness", 0, whole, softness);
    readWhole(json, "smoothness", 0, whole, smoothness);
    readWhole(json, "edge", 0, whole, edge);
    readNumber(json, "edgeGradient", 0.0, maximumGradient, edgeGradient);
    readWhole(json, "generations", 1, core::mostContourGenerations, generations);
}

} // namespace ui
