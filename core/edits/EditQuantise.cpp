// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditQuantise.h"

#include "core/edits/kinds/AnyEdit.h"

#include <algorithm>
#include <cmath>

namespace core {

using editSchema::Presence;

namespace {

class Rounder {
public:
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value& value, const Kind& kind, const char*)
    {
        value = kind.rounded(value);
    }
    template <class Kind>
    void maybe(const char*, std::optional<typename Kind::Value>& value, const Kind& kind,
        const char*, const char* = nullptr)
    {
        if (value)
            value = kind.rounded(*value);
    }
    void constant(const char*, Presence, const QJsonValue&, const char*) { }
    template <class Inside> void group(const char*, const char*, const Inside& visitInside)
    {
        visitInside(*this);
    }
    template <class Value, class Inside>
    void maybeGroup(const char*, std::optional<Value>& value, const char*, const char*,
        const Inside& visitInside)
    {
        if (value)
            visitInside(*this, *value);
    }
    template <class Inside> void when(bool condition, const Inside& visitInside)
    {
        if (condition)
            visitInside();
    }
};

} // namespace

Edit quantised(const Edit& edit)
{
    Edit result = edit;
    Rounder rounder;
    visitEdit([&rounder](auto& fields) { editSchema::visitFields(rounder, fields); }, result);
    return result;
}

std::vector<PenSample> quantised(const std::vector<PenSample>& samples)
{
    return editFields::SampleList().rounded(samples);
}

std::vector<glm::dvec3> quantised(const std::vector<glm::dvec3>& pointsLps)
{
    return editFields::PointList{editSchema::positionLps}.rounded(pointsLps);
}

std::vector<double> quantisedPressures(const std::vector<double>& pressures)
{
    std::vector<double> sound = pressures;
    for (double& pressure : sound)
        pressure = std::isfinite(pressure) ? std::clamp(pressure, 0.0, 1.0) : 0.0;
    return editFields::PressureList().rounded(sound);
}

} // namespace core
