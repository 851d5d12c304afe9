// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ImageMacros.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

void readPosition(const HeaderAttributes& from, ImageHeader& header)
{
    const std::vector<double> position = from.numbers(DCM_ImagePositionPatient);
    if (position.size() == 3)
        header.position = glm::dvec3(position[0], position[1], position[2]);
}

void readOrientation(const HeaderAttributes& from, ImageHeader& header)
{
    const std::vector<double> cosines = from.numbers(DCM_ImageOrientationPatient);
    if (cosines.size() != 6)
        return;
    const glm::dvec3 row(cosines[0], cosines[1], cosines[2]);
    const glm::dvec3 column(cosines[3], cosines[4], cosines[5]);
    constexpr double tolerance = 1e-2;
    const bool sound = std::abs(glm::length(row) - 1.0) < tolerance
        && std::abs(glm::length(column) - 1.0) < tolerance
        && std::abs(glm::dot(row, column)) < tolerance;
    if (sound)
        header.plane = ImagePlane{glm::normalize(row), glm::normalize(column)};
}

void readMeasures(const HeaderAttributes& from, ImageHeader& header)
{
    // First the distance between rows, then the one between columns (PS3.3 10.7.1.3).
    const std::vector<double> spacing = from.numbers(DCM_PixelSpacing);
    if (spacing.size() == 2 && spacing[0] > 0.0 && spacing[1] > 0.0)
        header.spacing = glm::dvec2(spacing[1], spacing[0]);
    if (const std::optional<double> thickness = from.number(DCM_SliceThickness))
        header.sliceThickness = std::max(0.0, *thickness);
    if (const std::optional<double> distance = from.number(DCM_SpacingBetweenSlices))
        header.spacingBetweenSlices = std::abs(*distance);
}

void readRescale(const HeaderAttributes& from, ImageHeader& header)
{
    const std::optional<double> slope = from.number(DCM_RescaleSlope);
    const std::optional<double> intercept = from.number(DCM_RescaleIntercept);
    header.hasRescale = slope && intercept && *slope != 0.0;
    header.slope = slope && *slope != 0.0 ? *slope : 1.0;
    header.intercept = intercept.value_or(0.0);
    header.rescaleType = from.text(DCM_RescaleType);
}

void readDoseScale(const HeaderAttributes& from, ImageHeader& header)
{
    const double scale = from.number(DCM_DoseGridScaling).value_or(0.0);
    if (scale <= 0.0)
        return;
    header.hasRescale = true;
    header.slope = scale;
    header.intercept = 0.0;
    header.units = from.text(DCM_DoseUnits);
}

void readWindow(const HeaderAttributes& from, ImageHeader& header)
{
    const std::optional<double> centre = from.number(DCM_WindowCenter);
    const std::optional<double> width = from.number(DCM_WindowWidth);
    // LINEAR knows no width below 1 (PS3.3 C.11.2.1.2.1). Where stored values stand for fractions
    // files state one nevertheless (of an SUV, an ADC, an anisotropy), and mean it.
    const double least = std::abs(header.slope) == 1.0 ? 1.0 : std::numeric_limits<double>::min();
    if (centre && width && *width >= least)
        header.window = WindowLevel{*centre, *width};
}

} // namespace core
