// SPDX-License-Identifier: Apache-2.0
#include "ui/base/StudyTexts.h"

#include "core/measure/MeasuredSize.h"
#include "ui/base/NumberText.h"

#include <QObject>

#include <cmath>

namespace ui {

namespace {

QString joined(QStringList parts)
{
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

QString prefixed(const QString& prefix, const QString& value)
{
    return value.isEmpty() ? QString() : prefix + value;
}

/// Whether nobody knows what a voxel of it comes to.
bool isUnknownIn(const core::Volume& volume)
{
    return core::unknownSpacing(volume) != core::UnknownSpacing::Nothing;
}

QString voxelsText(std::int64_t voxels)
{
    return (voxels == 1 ? QObject::tr("%1 voxel") : QObject::tr("%1 voxels"))
        .arg(countText(voxels));
}

/// @param sized by the mean distance of slices
QString nearly(const core::Volume& volume, std::int64_t voxels, const QString& sized)
{
    return volume.geometry.slicePositions.empty() || voxels == 0 ? sized
                                                                 : QObject::tr("≈ %1").arg(sized);
}

} // namespace

QString personName(const QString& dicomName)
{
    // PS3.5 6.2.1: family ^ given ^ middle ^ prefix ^ suffix; "=" parts ways of writing.
    const QStringList parts = dicomName.section(QLatin1Char('='), 0, 0).split(QLatin1Char('^'));
    const QString family = parts.value(0).trimmed();
    QStringList others = parts.mid(1);
    others.removeAll(QString());
    const QString rest = others.join(QLatin1Char(' ')).trimmed();
    if (family.isEmpty() || rest.isEmpty())
        return family + rest;
    return family + QStringLiteral(", ") + rest;
}

QStringList patientLines(const core::StudyIdentity& identity)
{
    QStringList lines{personName(identity.patientName),
        prefixed(QStringLiteral("ID "), identity.patientId),
        joined({prefixed(QStringLiteral("born "), identity.birthDate), identity.sex})};
    lines.removeAll(QString());
    return lines.isEmpty() ? QStringList{QObject::tr("patient not named in the source")} : lines;
}

QString patientText(const core::StudyIdentity& identity)
{
    return joined(patientLines(identity));
}

QString studyText(const core::StudyIdentity& identity)
{
    return joined({identity.modality, identity.studyDate});
}

QString seriesText(const core::StudyIdentity& identity)
{
    return joined(
        {prefixed(QStringLiteral("series "), identity.seriesNumber), identity.seriesDescription});
}

QString slicesApartText(const core::VolumeGeometry& geometry)
{
    return geometry.slicePositions.empty()
        ? QObject::tr("every %1 mm").arg(QString::number(geometry.spacingMm().z, 'g', 4))
        : QObject::tr("unevenly spaced");
}

QString valueText(double value, const QString& unit, double span)
{
    const QString number = numberText(value, decimalsForSpan(span));
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

QString toleranceText(int tolerance, const core::Volume& volume)
{
    const double step = std::abs(volume.encoding.rescaleSlope * volume.encoding.storedStep);
    return QChar(0xB1)
        + valueText(step * double(tolerance), volume.unit, volume.maximum - volume.minimum);
}

QString volumeText(const core::Volume& volume, std::int64_t voxels)
{
    if (isUnknownIn(volume))
        return voxelsText(voxels);
    constexpr double mm3PerMl = 1000.0;
    return nearly(
        volume, voxels, volumeText(double(voxels) * volume.geometry.voxelVolumeMm3() / mm3PerMl));
}

QString millilitreText(const core::Volume& volume, std::int64_t voxels)
{
    if (isUnknownIn(volume) && voxels > 0)
        return voxelsText(voxels);
    return nearly(volume, voxels, millilitreText(voxels, volume.geometry.voxelVolumeMm3()));
}

QString countedText(const core::Volume& volume, std::int64_t voxels)
{
    if (isUnknownIn(volume))
        return voxelsText(voxels);
    return QObject::tr("%1, %2").arg(voxelsText(voxels), volumeText(volume, voxels));
}

QString positionText(const glm::dvec3& lps)
{
    return QObject::tr("%1, %2, %3 mm")
        .arg(numberText(lps.x, 1), numberText(lps.y, 1), numberText(lps.z, 1));
}

} // namespace ui
