// SPDX-License-Identifier: Apache-2.0
#include "ui/base/SegmentCodes.h"

#include "ui/base/Icons.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace ui {

namespace {

std::vector<SegmentCode> readCodes()
{
    registerResources();
    std::vector<SegmentCode> result;
    QFile file(QStringLiteral(":/burin/segmentCodes.json"));
    if (!file.open(QIODevice::ReadOnly))
        return result;
    const QJsonArray groups = QJsonDocument::fromJson(file.readAll()).array();
    for (const QJsonValue& group : groups) {
        const QJsonArray concepts = group[QLatin1String("concepts")].toArray();
        for (const QJsonValue& entry : concepts) {
            result.push_back({group[QLatin1String("group")].toString(),
                {QStringLiteral("SCT"), entry[QLatin1String("value")].toString(),
                    entry[QLatin1String("meaning")].toString()}});
        }
    }
    return result;
}

} // namespace

const std::vector<SegmentCode>& segmentCodes()
{
    static const std::vector<SegmentCode> codes = readCodes();
    return codes;
}

} // namespace ui
