// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonValue>

#include <algorithm>
#include <cmath>

/// Reads values from the JSON in which a session keeps the state of the window (DisplayState). If
/// the JSON holds nothing sensible the target stays unchanged.
namespace ui::displayJson {

inline void read(const QJsonValue& json, double& value)
{
    if (json.isDouble() && std::isfinite(json.toDouble()))
        value = json.toDouble();
}

/// Values beyond the limits are clamped.
inline void read(const QJsonValue& json, double& value, double minimum, double maximum)
{
    read(json, value);
    value = std::clamp(value, minimum, maximum);
}

inline void read(const QJsonValue& json, bool& value)
{
    value = json.toBool(value);
}

} // namespace ui::displayJson
