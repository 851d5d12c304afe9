// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonValue>

#include <algorithm>
#include <cmath>

/// Plain values of what a session keeps of the window (DisplayState). Reading leaves the target
/// alone where there is nothing sensible.
namespace ui::displayJson {

inline void read(const QJsonValue& json, double& value)
{
    if (json.isDouble() && std::isfinite(json.toDouble()))
        value = json.toDouble();
}

/// Values beyond the limits come to them.
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
