// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditQuantise.h"

#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/schema/FieldVisitor.h"

#include <algorithm>
#include <cmath>

namespace core {

using editSchema::Presence;

namespace {

class Rounder : public editSchema::FieldVisitor<Rounder> {
public:
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value& value, const Kind& kind, const char*)
    {
        value = kind.rounded(value);
    }
};

/// An overload for everything that an open edit can be told.
struct ExtensionRounder {
    using Rounded = std::optional<StrokeExtension>;

    Rounded operator()(const PenSamples& pen) const { return PenSamples{quantised(pen.samples)}; }
    Rounded operator()(const PathPoints& path) const
    {
        return PathPoints{.pointsLps = quantised(path.pointsLps),
            .lifted = path.lifted,
            .pressures = quantisedPressures(path.pressures)};
    }
    Rounded operator()(const ToDepth& to) const
    {
        const editFields::Number& field = editSchema::peelDepth;
        return field.check(to.mm).isEmpty() ? Rounded(ToDepth{field.rounded(to.mm)}) : std::nullopt;
    }
    Rounded operator()(const ToSteps& to) const
    {
        return to.steps >= 0 ? Rounded(to) : std::nullopt;
    }
    Rounded operator()(const ToInterval& to) const
    {
        const editFields::Number& field = editSchema::modalityValue;
        const bool isInRange = to.lower <= to.upper && field.check(to.lower).isEmpty()
            && field.check(to.upper).isEmpty();
        return isInRange ? Rounded(
                   ToInterval{.lower = field.rounded(to.lower), .upper = field.rounded(to.upper)})
                         : std::nullopt;
    }
    Rounded operator()(const GrowAdvance& advance) const { return advance; }
    Rounded operator()(const PauseGrowth& pause) const { return pause; }
    Rounded operator()(const ForgetPreview& forget) const { return forget; }
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

std::optional<StrokeExtension> quantisedIfInRange(const StrokeExtension& extension)
{
    return std::visit(ExtensionRounder(), extension);
}

} // namespace core
