// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/MeasureTexts.h"

#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

using Kind = core::Measurement::Kind;

/// The words' context for translators.
struct MeasureTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::MeasureTexts)
};

constexpr double mm3PerMl = 1000.0;

QString lengthIn(double length, bool voxels)
{
    return voxels ? MeasureTexts::tr("%1 voxels").arg(numberText(length, 1)) : lengthText(length);
}

QString areaIn(double area, bool voxels)
{
    return (voxels ? MeasureTexts::tr("%1 voxels²") : MeasureTexts::tr("%1 mm²"))
        .arg(numberText(area, 1));
}

QString axesIn(double longer, double shorter, bool voxels)
{
    return (voxels ? MeasureTexts::tr("%1 × %2 voxels") : MeasureTexts::tr("%1 × %2 mm"))
        .arg(numberText(longer, 1), numberText(shorter, 1));
}

QString ballVolume(double volume, bool voxels)
{
    if (voxels)
        return MeasureTexts::tr("%1 voxels").arg(numberText(volume, 0));
    const double millilitres = volume / mm3PerMl;
    return MeasureTexts::tr("%1 mL").arg(numberText(millilitres, millilitres < 10.0 ? 3 : 1));
}

} // namespace

QString lengthText(double mm)
{
    return MeasureTexts::tr("%1 mm").arg(numberText(mm, 1));
}

QString kindText(Kind kind)
{
    switch (kind) {
    case Kind::Distance:
        return MeasureTexts::tr("distance");
    case Kind::Angle:
        return MeasureTexts::tr("angle");
    case Kind::Ellipse:
        return MeasureTexts::tr("ellipse");
    case Kind::Rectangle:
        return MeasureTexts::tr("rectangle");
    case Kind::Outline:
        return MeasureTexts::tr("freehand");
    case Kind::Ball:
        return MeasureTexts::tr("ball");
    case Kind::Probe:
        return MeasureTexts::tr("probe");
    case Kind::Arrow:
        return MeasureTexts::tr("arrow");
    case Kind::Text:
        return MeasureTexts::tr("text");
    }
    return {};
}

QStringList sizeLines(const core::Measurement& measurement, const core::MeasuredSize& size)
{
    QStringList lines;
    if (!measurement.text.isEmpty())
        lines += measurement.text;
    if (size.length)
        lines += lengthIn(*size.length, size.inVoxels);
    if (size.angleDegrees)
        lines += MeasureTexts::tr("%1°").arg(numberText(*size.angleDegrees, 1));
    if (size.area)
        lines += areaIn(*size.area, size.inVoxels);
    if (size.volume)
        lines += ballVolume(*size.volume, size.inVoxels);
    if (size.longAxis && size.shortAxis)
        lines += axesIn(*size.longAxis, *size.shortAxis, size.inVoxels);
    else if (size.longAxis)
        lines += QStringLiteral("⌀ ") + lengthIn(*size.longAxis, size.inVoxels);
    if (measurement.projected)
        lines += MeasureTexts::tr("projected");
    return lines;
}

QStringList valueLines(const core::Measurement& measurement, const core::RegionStatistics& values,
    const core::Volume& volume)
{
    const double span = volume.maximum - volume.minimum;
    if (measurement.kind == Kind::Probe)
        return {valueText(values.mean, volume.unit, span)};
    // A mean has a digit more than the values that it is of.
    return {MeasureTexts::tr("mean %1 ± %2")
                .arg(valueText(values.mean, QString(), span / 10.0),
                    valueText(values.deviation, volume.unit, span / 10.0)),
        MeasureTexts::tr("%1 … %2 in %3")
            .arg(valueText(values.minimum, QString(), span),
                valueText(values.maximum, volume.unit, span))
            .arg(values.voxels)};
}

glm::dvec3 middleOf(const core::Measurement& measurement)
{
    const std::vector<glm::dvec3>& points = measurement.pointsLps;
    switch (measurement.kind) {
    case Kind::Distance:
        return (points[0] + points[1]) / 2.0;
    case Kind::Angle:
        return points[1];
    case Kind::Rectangle:
        return (points[1] + points[2]) / 2.0;
    case Kind::Outline: {
        glm::dvec3 sum(0.0);
        for (const glm::dvec3& point : points)
            sum += point;
        return sum / double(points.size());
    }
    case Kind::Ellipse:
    case Kind::Ball:
    case Kind::Probe:
    case Kind::Arrow:
    case Kind::Text:
        break;
    }
    return points[0];
}

} // namespace ui
