// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SrMeasured.h"

#include "core/dicom/base/NewUid.h"
#include "core/dicom/write/SrTree.h"
#include "core/measure/PlaneShape.h"

#include <cmath>

namespace core {

namespace {

using Kind = Measurement::Kind;

struct Graphic {
    const char* type = "";
    std::vector<glm::dvec3> places{};
};

/// Both ends of the longer axis, then of the shorter, as DICOM has ellipses.
std::vector<glm::dvec3> axisEnds(const glm::dvec3& centre, const glm::dvec3& a, const glm::dvec3& b)
{
    const bool longer = glm::length(a) >= glm::length(b);
    const glm::dvec3& major = longer ? a : b;
    const glm::dvec3& minor = longer ? b : a;
    return {centre - major, centre + major, centre - minor, centre + minor};
}

Graphic graphicOf(const Measurement& measurement, const VolumeGeometry& geometry)
{
    std::vector<glm::dvec3> at;
    for (const glm::dvec3& point : measurement.pointsLps)
        at.push_back(truePlace(geometry, point));
    switch (measurement.kind) {
    case Kind::Distance:
    case Kind::Angle:
        return {"POLYLINE", at};
    case Kind::Ellipse:
        return {"ELLIPSE", axisEnds(at[0], at[1] - at[0], at[2] - at[0])};
    case Kind::Rectangle:
        return {"POLYGON", {at[0], at[1], at[1] + at[2] - at[0], at[2], at[0]}};
    case Kind::Outline:
        at.push_back(at.front());
        return {"POLYGON", at};
    case Kind::Ball: {
        const double radius = glm::distance(at[0], at[1]);
        std::vector<glm::dvec3> ends;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 way(0.0);
            way[axis] = radius;
            ends.push_back(at[0] - way);
            ends.push_back(at[0] + way);
        }
        return {"ELLIPSOID", ends};
    }
    case Kind::Probe:
    case Kind::Arrow:
    case Kind::Text:
        break;
    }
    return {"POINT", {at[0]}};
}

void putSizes(DcmItem* group, const Measured& measured, const SrMeasuredSource& source,
    const SrTree& tree, const Graphic& graphic)
{
    const bool voxels = measured.size.inVoxels;
    const CodedConcept inVoxels = schemeCode("UCUM", "{voxels}", "voxels");
    const CodedConcept length = voxels ? inVoxels : schemeCode("UCUM", "mm", "millimeter");
    // Of a line or an angle the places belong to the number.
    const auto number = [&](const std::optional<double>& value, const CodedConcept& name,
                            const CodedConcept& unit) {
        if (!value)
            return;
        DcmItem* item = tree.number(group, name, *value, unit);
        if (!measured.measurement.isRegion() && !source.frameOfReferenceUid.isEmpty())
            tree.places(item, "INFERRED FROM", dicomCode("121112", "Source of Measurement"),
                graphic.type, graphic.places, source.frameOfReferenceUid);
    };
    const MeasuredSize& size = measured.size;
    number(size.length, schemeCode("SCT", "410668003", "Length"), length);
    number(size.angleDegrees, schemeCode("SCT", "1483009", "Angle"),
        schemeCode("UCUM", "deg", "degree"));
    number(size.area, schemeCode("SCT", "42798000", "Area"),
        voxels ? inVoxels : schemeCode("UCUM", "mm2", "square millimeter"));
    constexpr double mm3PerMl = 1000.0;
    std::optional<double> volume = size.volume;
    if (volume && !voxels)
        *volume /= mm3PerMl;
    number(volume, schemeCode("SCT", "118565006", "Volume"),
        voxels ? inVoxels : schemeCode("UCUM", "cm3", "cubic centimeter"));
    if (size.shortAxis) {
        number(size.longAxis, schemeCode("SCT", "103339001", "Long Axis"), length);
        number(size.shortAxis, schemeCode("SCT", "103340004", "Short Axis"), length);
    } else {
        number(size.longAxis, schemeCode("SCT", "81827009", "Diameter"), length);
    }
}

} // namespace

void putMeasured(DcmItem* measurements, const Measured& measured, const SrMeasuredSource& source,
    const SrTree& tree)
{
    const Measurement& measurement = measured.measurement;
    if (measurement.kind == Kind::Arrow || measurement.kind == Kind::Text)
        return;
    const Graphic graphic = graphicOf(measurement, source.geometry);
    DcmItem* group = tree.container(measurements, dicomCode("125007", "Measurement Group"));
    tree.text(group, dicomCode("112039", "Tracking Identifier"),
        (measurement.projected ? QStringLiteral("Measurement %1, projected")
                               : QStringLiteral("Measurement %1"))
            .arg(measurement.id));
    tree.uid(group, "HAS OBS CONTEXT", dicomCode("112040", "Tracking Unique Identifier"), newUid());
    const bool isPlaced = !source.frameOfReferenceUid.isEmpty();
    if (isPlaced && measurement.isRegion())
        tree.places(group, "CONTAINS",
            measurement.kind == Kind::Ball ? dicomCode("121231", "Volume Surface")
                                           : dicomCode("111030", "Image Region"),
            graphic.type, graphic.places, source.frameOfReferenceUid);
    if (measurement.isRegion())
        tree.uid(group, "CONTAINS", dicomCode("121232", "Source series for segmentation"),
            source.series);
    putSizes(group, measured, source, tree, graphic);
    if (!measured.values)
        return;
    const CodedConcept quantity = quantityOf(source.unit, source.modality);
    const CodedConcept unit = unitCode(source.unit);
    if (measurement.kind == Kind::Probe) {
        DcmItem* item = tree.number(group, quantity, measured.values->mean, unit);
        if (isPlaced)
            tree.places(item, "INFERRED FROM", dicomCode("121112", "Source of Measurement"),
                graphic.type, graphic.places, source.frameOfReferenceUid);
        return;
    }
    tree.derived(
        group, quantity, measured.values->mean, unit, schemeCode("SCT", "373098007", "Mean"));
    tree.derived(group, quantity, measured.values->deviation, unit,
        schemeCode("SCT", "386136009", "Standard Deviation"));
    tree.derived(
        group, quantity, measured.values->minimum, unit, schemeCode("SCT", "255605001", "Minimum"));
    tree.derived(
        group, quantity, measured.values->maximum, unit, schemeCode("SCT", "56851009", "Maximum"));
}

} // namespace core
