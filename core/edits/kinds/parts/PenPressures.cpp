// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/parts/PenPressures.h"

#include <algorithm>
#include <cmath>

namespace core {

Result<void> checkPressures(const PenPressures& pressures, std::size_t points, const QString& name)
{
    if (!pressures || pressures->size() == points)
        return {};
    return failure(ErrorCode::InvalidField, name + QStringLiteral(".pressures"),
        Clause::saying("%1 for %2 points", pressures->size(), points));
}

std::vector<double> continuePressures(
    PenPressures& pressures, std::size_t points, const std::vector<double>& told)
{
    if (!pressures)
        return {};
    std::vector<double> further;
    for (std::size_t i = 0; i < points; ++i) {
        const double pressure = i < told.size() ? told[i] : 1.0;
        further.push_back(std::isfinite(pressure) ? std::clamp(pressure, 0.0, 1.0) : 0.0);
    }
    pressures->insert(pressures->end(), further.begin(), further.end());
    return further;
}

} // namespace core
