// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/GrowLimits.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/parts/GrowBox.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

// GrowLimits: ta = weight · difference / 1024, at most 32767.
constexpr double weightUnit = 1024.0;
constexpr double greatestPart = 32767.0;
constexpr double greatestWeight = 65535.0;
constexpr int greatestMagnitude = 65534;

constexpr double unitsPerVoxel = 16.0; // Passage: of the finest spacing
constexpr double greatestPassageSpacing = 256.0; // no ball reaches as far

double finestSpacing(const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return std::min({spacing.x, spacing.y, spacing.z});
}

int magnitudeAtMost(double bound, const GradientScale& scale)
{
    return int(std::clamp(std::floor(bound * scale.perUnit), 0.0, double(greatestMagnitude)));
}

} // namespace

int greatestDifference(const VoxelEncoding& encoding, double bound)
{
    const double step = std::abs(encoding.rescaleSlope * double(encoding.storedStep));
    int atMost = -1;
    int above = VoxelEncoding::codeCount;
    while (above - atMost > 1) {
        const int middle = (above + atMost) / 2;
        (step * double(middle) <= bound ? atMost : above) = middle;
    }
    return atMost;
}

GradientScale gradientScale(const Volume& volume)
{
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z});
    // A central difference spans two voxels: the greatest is half the range a voxel.
    const int range =
        std::max(greatestDifference(volume.encoding, volume.maximum - volume.minimum), 1);
    const double perCode = std::min(greatestPart / range, greatestWeight / weightUnit);
    GradientScale scale;
    for (int axis = 0; axis < 3; ++axis)
        scale.weights[axis] = int(std::floor(weightUnit * perCode * finest / spacing[axis] + 0.5));
    const double step = std::abs(volume.encoding.rescaleSlope * volume.encoding.storedStep);
    scale.perUnit = step > 0.0 ? 2.0 * finest * perCode / step : 0.0;
    return scale;
}

double greatestPassageMm(const VolumeGeometry& geometry)
{
    return (2.0 * greatestPassageReach + 1.0) * finestSpacing(geometry);
}

double leastPassageMm(const VolumeGeometry& geometry)
{
    return 2.0 * finestSpacing(geometry);
}

Passage passageOf(double widthMm, const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    const double unitsPerMm = unitsPerVoxel / finestSpacing(geometry);
    Passage passage;
    for (int axis = 0; axis < 3; ++axis)
        passage.spacing[axis] =
            int(std::min(std::floor(spacing[axis] * unitsPerMm + 0.5), greatestPassageSpacing));
    const double half = 0.5 * widthMm * unitsPerMm;
    // Squares are whole numbers: a half width that ends at a voxel's centre holds that voxel.
    passage.reach = int(std::floor(half * half + 0.5));
    return isAsked(passage) ? passage : Passage{};
}

Result<GrowLimits> growLimits(
    const GrowCriteria& criteria, const Volume& volume, const QString& edit)
{
    GrowLimits limits;
    if (criteria.difference)
        limits.difference = greatestDifference(volume.encoding, *criteria.difference);
    if (criteria.gradient || criteria.gradientDifference) {
        const GradientScale scale = gradientScale(volume);
        limits.gradientWeights = scale.weights;
        if (criteria.gradient)
            limits.gradient = magnitudeAtMost(*criteria.gradient, scale);
        if (criteria.gradientDifference)
            limits.gradientDifference = magnitudeAtMost(*criteria.gradientDifference, scale);
    }
    limits.majority = criteria.majority.value_or(0);
    limits.smoothed = criteria.smoothing.value_or(false);
    if (criteria.passage) {
        // A number typed from what the limit is shown as may be rounded up.
        if (*criteria.passage > greatestPassageMm(volume.geometry) * (1.0 + 1e-9))
            return failure(ErrorCode::InvalidField, edit + QStringLiteral(".passage"),
                Clause::saying("at most %1 mm, 31 times the finest spacing of this volume",
                    greatestPassageMm(volume.geometry)));
        limits.passage = passageOf(*criteria.passage, volume.geometry);
    }
    limits.onlyVisible = criteria.onlyVisible;
    const auto keepTo = [&](const std::optional<GrowBox>& box, const char* field) -> Result<void> {
        if (!box)
            return {};
        const Result<VoxelSpan> span =
            voxelsOf(*box, volume.geometry, edit + QLatin1Char('.') + QLatin1String(field));
        if (!span)
            return tl::unexpected(span.error());
        limits.boxFrom = limits.boxed ? glm::max(limits.boxFrom, span->from) : span->from;
        limits.boxTo = limits.boxed ? glm::min(limits.boxTo, span->to) : span->to;
        limits.boxed = true;
        return {};
    };
    if (const Result<void> kept = keepTo(criteria.box, "box"); !kept)
        return tl::unexpected(kept.error());
    if (criteria.editable) {
        const Result<void> kept = keepTo(criteria.editable->box, "editable.box");
        if (!kept)
            return tl::unexpected(kept.error());
    }
    if (criteria.sigmas)
        limits.sigmas256 = int(std::floor(*criteria.sigmas * 256.0 + 0.5));
    return limits;
}

} // namespace core
