// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/GrowSettings.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowLimits.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "ui/base/DisplayJson.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ui {

namespace {

using Limit = GrowSettings::Limit;
using displayJson::read;

constexpr QLatin1String guardName("guard");
constexpr QLatin1String guardAreaName("guardAreaMm2");

/// Every limit that has a value, by its name in JSON.
template <class Settings> auto limitsOf(Settings& settings)
{
    return std::array{std::pair{"sigmas", &settings.sigmas},
        std::pair{"difference", &settings.difference}, std::pair{"gradient", &settings.gradient},
        std::pair{"gradientDifference", &settings.gradientDifference},
        std::pair{"majority", &settings.majority}, std::pair{"passage", &settings.passage}};
}

std::optional<double> asked(const Limit& limit)
{
    return limit.on ? std::optional(limit.value) : std::nullopt;
}

QJsonArray toJson(const glm::dvec3& point)
{
    return {point.x, point.y, point.z};
}

QJsonObject toJson(const Limit& limit)
{
    return {{QStringLiteral("on"), limit.on}, {QStringLiteral("value"), limit.value}};
}

void read(const QJsonValue& json, Limit& limit)
{
    read(json[QLatin1String("on")], limit.on);
    read(json[QLatin1String("value")], limit.value, 0.0, 1e300);
}

bool read(const QJsonValue& json, glm::dvec3& point)
{
    const QJsonArray array = json.toArray();
    for (int axis = 0; axis < 3; ++axis) {
        if (!array.at(axis).isDouble() || !std::isfinite(array.at(axis).toDouble()))
            return false;
        point[axis] = array.at(axis).toDouble();
    }
    return array.size() == 3;
}

/// 1, 2 or 5 times a power of ten, about as large.
double roundNumber(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

} // namespace

core::GrowCriteria criteriaOf(const GrowSettings& settings)
{
    core::GrowCriteria criteria;
    criteria.lower = settings.lower;
    criteria.upper = settings.upper;
    criteria.connectivity = settings.connectivity;
    criteria.sigmas = asked(settings.sigmas);
    if (criteria.sigmas)
        criteria.perStroke = true;
    criteria.difference = asked(settings.difference);
    criteria.gradient = asked(settings.gradient);
    criteria.gradientDifference = asked(settings.gradientDifference);
    if (settings.majority.on)
        criteria.majority = int(std::lround(settings.majority.value));
    if (settings.smoothing)
        criteria.smoothing = true;
    criteria.passage = asked(settings.passage);
    criteria.onlyVisible = settings.onlyVisible;
    if (settings.boxed)
        criteria.box = settings.box;
    criteria.overwriteUnlocked = settings.overwriteUnlocked;
    return criteria;
}

void takeCriteria(const core::GrowCriteria& criteria, GrowSettings& settings)
{
    const auto take = [](Limit& limit, const auto& value) {
        limit.on = value.has_value();
        if (value)
            limit.value = double(*value);
    };
    settings.lower = criteria.lower;
    settings.upper = criteria.upper;
    settings.connectivity = criteria.connectivity;
    take(settings.sigmas, criteria.sigmas);
    take(settings.difference, criteria.difference);
    take(settings.gradient, criteria.gradient);
    take(settings.gradientDifference, criteria.gradientDifference);
    take(settings.majority, criteria.majority);
    settings.smoothing = criteria.smoothing.value_or(false);
    take(settings.passage, criteria.passage);
    settings.onlyVisible = criteria.onlyVisible;
    settings.boxed = criteria.box.has_value();
    if (criteria.box)
        settings.box = criteria.box;
    settings.overwriteUnlocked = criteria.overwriteUnlocked;
}

core::GrowSteps growthOf(const GrowSettings& settings)
{
    return {.criteria = criteriaOf(settings),
        .guard = {.factor = asked(settings.guard), .areaMm2 = settings.guardAreaMm2}};
}

int limitsOn(const GrowSettings& settings)
{
    int count = int(settings.smoothing) + int(settings.onlyVisible) + int(settings.boxed);
    for (const auto& [name, limit] : limitsOf(settings))
        count += limit->on ? 1 : 0;
    return count;
}

void chooseLimits(GrowSettings& settings, const core::Volume& volume)
{
    const double width = std::max(volume.defaultWindow.width, 1e-6);
    for (Limit* limit : {&settings.difference, &settings.gradient, &settings.gradientDifference}) {
        if (limit->value == 0.0)
            limit->value = roundNumber(width / (limit == &settings.difference ? 10.0 : 5.0));
    }
    double& passage = settings.passage.value;
    const double least = core::leastPassageMm(volume.geometry);
    if (passage == 0.0)
        passage = roundNumber(2.0 * least);
    passage = std::clamp(passage, least, core::greatestPassageMm(volume.geometry));
}

std::optional<core::ClipRegion::Box> growBoxOf(
    const GrowSettings& settings, const core::VolumeGeometry& geometry)
{
    if (!settings.boxed || !settings.box)
        return std::nullopt;
    const auto span = core::voxelsOf(*settings.box, geometry, {});
    if (!span)
        return std::nullopt;
    return core::ClipRegion::Box{
        .minimum = glm::dvec3(span->from) - 0.5, .maximum = glm::dvec3(span->to) + 0.5, .on = true};
}

core::GrowBox growBoxFrom(const core::ClipRegion::Box& box, const core::VolumeGeometry& geometry)
{
    const glm::dvec3 last(geometry.size - 1);
    const glm::dvec3 from = glm::clamp(glm::ceil(box.minimum - 1e-6), glm::dvec3(0.0), last);
    const glm::dvec3 to = glm::clamp(glm::floor(box.maximum + 1e-6), from, last);
    return {.fromLps = geometry.toWorld(from), .toLps = geometry.toWorld(to)};
}

QJsonObject growSettingsJson(const GrowSettings& settings)
{
    QJsonObject json{{QStringLiteral("lower"), settings.lower},
        {QStringLiteral("upper"), settings.upper},
        {QStringLiteral("overwriteUnlocked"), settings.overwriteUnlocked},
        {QStringLiteral("connectivity"), settings.connectivity},
        {QStringLiteral("generationsPerSecond"), settings.generationsPerSecond},
        {QStringLiteral("smoothing"), settings.smoothing},
        {QStringLiteral("onlyVisible"), settings.onlyVisible},
        {QStringLiteral("boxed"), settings.boxed}};
    for (const auto& [name, limit] : limitsOf(settings))
        json[QLatin1String(name)] = toJson(*limit);
    json[guardName] = toJson(settings.guard);
    json[guardAreaName] = settings.guardAreaMm2;
    if (settings.box)
        json[QStringLiteral("box")] =
            QJsonArray{toJson(settings.box->fromLps), toJson(settings.box->toLps)};
    return json;
}

void readGrowSettings(const QJsonObject& json, GrowSettings& settings)
{
    GrowSettings known = settings;
    read(json[QLatin1String("lower")], known.lower);
    read(json[QLatin1String("upper")], known.upper);
    read(json[QLatin1String("overwriteUnlocked")], known.overwriteUnlocked);
    const int connectivity = json[QLatin1String("connectivity")].toInt();
    if (connectivity == 6 || connectivity == 18 || connectivity == 26)
        known.connectivity = connectivity;
    read(json[QLatin1String("generationsPerSecond")], known.generationsPerSecond);
    read(json[QLatin1String("smoothing")], known.smoothing);
    read(json[QLatin1String("onlyVisible")], known.onlyVisible);
    read(json[QLatin1String("boxed")], known.boxed);
    for (const auto& [name, limit] : limitsOf(known))
        read(json[QLatin1String(name)], *limit);
    read(json[guardName], known.guard);
    known.guard.value = std::clamp(known.guard.value, leastGuard, greatestGuard);
    read(json[guardAreaName], known.guardAreaMm2);
    known.guardAreaMm2 = std::clamp(known.guardAreaMm2, leastGuardAreaMm2, greatestGuardAreaMm2);
    known.sigmas.value = std::clamp(known.sigmas.value, 1.0 / 256.0, 100.0);
    known.majority.value = std::clamp(known.majority.value, 1.0, 27.0);
    const QJsonArray box = json[QLatin1String("box")].toArray();
    core::GrowBox corners;
    if (box.size() == 2 && read(box.at(0), corners.fromLps) && read(box.at(1), corners.toLps))
        known.box = corners;
    if (known.lower <= known.upper && known.generationsPerSecond >= 0.0)
        settings = known;
}

} // namespace ui
