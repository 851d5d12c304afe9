// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionSource.h"

#include <QFileInfo>
#include <QJsonArray>

#include <cmath>

namespace core {

SessionSource SessionSource::of(const Volume& volume)
{
    return {.path = QFileInfo(volume.sourcePath).absoluteFilePath(),
        .format = volume.sourceFormat,
        .studyUid = volume.identity.studyUid,
        .seriesUid = volume.identity.seriesUid,
        .size = volume.geometry.size,
        .indexToWorld = volume.geometry.indexToWorld,
        .voxelsSha256 = volume.voxelsSha256};
}

QJsonObject SessionSource::toJson() const
{
    QJsonArray matrix;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            matrix.append(indexToWorld[column][row]);
    }
    return {
        {QStringLiteral("path"), path},
        {QStringLiteral("format"), format},
        {QStringLiteral("studyUid"), studyUid},
        {QStringLiteral("seriesUid"), seriesUid},
        {QStringLiteral("size"), QJsonArray{size.x, size.y, size.z}},
        {QStringLiteral("indexToWorld"), matrix},
        {QStringLiteral("voxelsSha256"), QString::fromLatin1(voxelsSha256)},
    };
}

std::optional<SessionSource> SessionSource::fromJson(const QJsonObject& json)
{
    const QJsonArray sizes = json.value(QStringLiteral("size")).toArray();
    const QJsonArray matrix = json.value(QStringLiteral("indexToWorld")).toArray();
    if (sizes.size() != 3 || matrix.size() != 16)
        return {};
    SessionSource source;
    source.path = json.value(QStringLiteral("path")).toString();
    source.format = json.value(QStringLiteral("format")).toString();
    source.studyUid = json.value(QStringLiteral("studyUid")).toString();
    source.seriesUid = json.value(QStringLiteral("seriesUid")).toString();
    source.voxelsSha256 = json.value(QStringLiteral("voxelsSha256")).toString().toLatin1();
    for (int axis = 0; axis < 3; ++axis)
        source.size[axis] = sizes[axis].toInt();
    for (int i = 0; i < 16; ++i)
        source.indexToWorld[i / 4][i % 4] = matrix[i].toDouble();
    return source;
}

QString SessionSource::differenceFrom(const Volume& volume) const
{
    if (volume.geometry.size != size)
        return QStringLiteral("its size is another");
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            const double other = volume.geometry.indexToWorld[column][row];
            if (!(std::abs(other - indexToWorld[column][row]) <= 1e-6))
                return QStringLiteral("it lies elsewhere in the patient");
        }
    }
    if (!voxelsSha256.isEmpty() && !volume.voxelsSha256.isEmpty()
        && voxelsSha256 != volume.voxelsSha256)
        return QStringLiteral("its voxels are others");
    if (!seriesUid.isEmpty() && !volume.identity.seriesUid.isEmpty()
        && seriesUid != volume.identity.seriesUid)
        return QStringLiteral("its series UID is another");
    return {};
}

} // namespace core
