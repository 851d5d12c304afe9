// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionSource.h"

#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace core {

namespace {

QString sizeText(const glm::ivec3& size)
{
    return QStringLiteral("%1 × %2 × %3").arg(size.x).arg(size.y).arg(size.z);
}

QString pointText(const glm::dvec4& point)
{
    return QStringLiteral("%1, %2, %3")
        .arg(point.x, 0, 'f', 2)
        .arg(point.y, 0, 'f', 2)
        .arg(point.z, 0, 'f', 2);
}

} // namespace

SessionSource SessionSource::of(const Volume& volume)
{
    const bool isInTime = volume.alternatives && volume.alternatives->times.size() > 1;
    return {.path = QFileInfo(volume.sourcePath).absoluteFilePath(),
        .format = volume.sourceFormat,
        .studyUid = volume.identity.studyUid,
        .seriesUid = volume.identity.seriesUid,
        .seriesDescription = volume.identity.seriesDescription,
        .modality = volume.identity.modality,
        .studyDate = volume.identity.studyDate,
        .repair = volume.repair,
        .time = isInTime ? volume.alternatives->time + 1 : 0,
        .size = volume.geometry.size,
        .indexToWorld = volume.geometry.indexToWorld,
        .voxelsSha256 = volume.voxelsSha256,
        .codesSha256 = volume.codesSha256};
}

QJsonObject SessionSource::toJson() const
{
    QJsonArray matrix;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            matrix.append(indexToWorld[column][row]);
    }
    QJsonObject json{
        {QStringLiteral("path"), path},
        {QStringLiteral("format"), format},
        {QStringLiteral("studyUid"), studyUid},
        {QStringLiteral("seriesUid"), seriesUid},
        {QStringLiteral("seriesDescription"), seriesDescription},
        {QStringLiteral("modality"), modality},
        {QStringLiteral("studyDate"), studyDate},
        {QStringLiteral("size"), QJsonArray{size.x, size.y, size.z}},
        {QStringLiteral("indexToWorld"), matrix},
        {QStringLiteral("voxelsSha256"), QString::fromLatin1(voxelsSha256)},
    };
    if (!repair.isEmpty())
        json[QStringLiteral("repair")] = repair;
    if (time > 0)
        json[QStringLiteral("time")] = time;
    if (!codesSha256.isEmpty())
        json[QStringLiteral("codesSha256")] = QString::fromLatin1(codesSha256);
    return json;
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
    source.seriesDescription = json.value(QStringLiteral("seriesDescription")).toString();
    source.modality = json.value(QStringLiteral("modality")).toString();
    source.studyDate = json.value(QStringLiteral("studyDate")).toString();
    source.repair = json.value(QStringLiteral("repair")).toString();
    source.time = std::max(0, json.value(QStringLiteral("time")).toInt());
    source.voxelsSha256 = json.value(QStringLiteral("voxelsSha256")).toString().toLatin1();
    source.codesSha256 = json.value(QStringLiteral("codesSha256")).toString().toLatin1();
    for (int axis = 0; axis < 3; ++axis)
        source.size[axis] = sizes[axis].toInt();
    for (int i = 0; i < 16; ++i)
        source.indexToWorld[i / 4][i % 4] = matrix[i].toDouble();
    return source;
}

Clause SessionSource::differenceFrom(const Volume& volume) const
{
    const auto repairText = [](const QString& words) {
        return words.isEmpty() ? Clause::saying("as it is") : Clause::saying("repaired: %1", words);
    };
    if (volume.repair != repair)
        return Clause::saying("its series is repaired otherwise (%1; the session's is %2)",
            repairText(volume.repair), repairText(repair));
    if (volume.geometry.size != size)
        return Clause::saying("its size is another (%1 voxels; the session was made on %2)",
            sizeText(volume.geometry.size), sizeText(size));
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            const double other = volume.geometry.indexToWorld[column][row];
            if (!(std::abs(other - indexToWorld[column][row]) <= 1e-6))
                return Clause::saying("it lies elsewhere in the patient (its first voxel at %1, the"
                                      " session's at %2; LPS mm)",
                    pointText(volume.geometry.indexToWorld[3]), pointText(indexToWorld[3]));
        }
    }
    if (!voxelsSha256.isEmpty() && !volume.voxelsSha256.isEmpty()
        && voxelsSha256 != volume.voxelsSha256)
        return Clause::saying("its voxels are others (SHA-256 %1…, the session's %2…)",
            QString::fromLatin1(volume.voxelsSha256.left(12)),
            QString::fromLatin1(voxelsSha256.left(12)));
    if (!seriesUid.isEmpty() && !volume.identity.seriesUid.isEmpty()
        && seriesUid != volume.identity.seriesUid)
        return Clause::saying("its series UID is another (%1; the session's is %2)",
            volume.identity.seriesUid, seriesUid);
    return {};
}

} // namespace core
