// SPDX-License-Identifier: Apache-2.0
#include "core/document/Document.h"

#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace core {

const Segment* Document::segment(int label) const
{
    const auto found = std::find_if(segments.begin(), segments.end(),
        [label](const Segment& candidate) { return candidate.label == label; });
    return found == segments.end() ? nullptr : &*found;
}

Segment* Document::segment(int label)
{
    return const_cast<Segment*>(std::as_const(*this).segment(label));
}

const Growth* Document::growth(int plane) const
{
    const auto found = std::find_if(growths.begin(), growths.end(),
        [plane](const Growth& candidate) { return candidate.plane == plane; });
    return found == growths.end() ? nullptr : &*found;
}

QJsonObject Document::hashedState() const
{
    QJsonArray segmentList;
    for (const Segment& segment : segments) {
        segmentList.append(QJsonObject{
            {QStringLiteral("code"),
                QJsonArray{segment.code.scheme, segment.code.value, segment.code.meaning}},
            {QStringLiteral("color"),
                QStringLiteral("#%1").arg(segment.rgb, 6, 16, QLatin1Char('0'))},
            {QStringLiteral("label"), int(segment.label)},
            {QStringLiteral("locked"), segment.locked},
            {QStringLiteral("name"), segment.name},
            {QStringLiteral("plane"), int(segment.plane)},
        });
    }
    QJsonArray layerList;
    for (const SculptLayer& layer : layers) {
        layerList.append(QJsonObject{
            {QStringLiteral("id"), int(layer.id)},
            {QStringLiteral("muted"), layer.muted},
            {QStringLiteral("name"), layer.name},
        });
    }
    QJsonArray growthList;
    for (const Growth& growth : growths) {
        growthList.append(QJsonObject{
            {QStringLiteral("generation"), qint64(growth.generation)},
            {QStringLiteral("plane"), int(growth.plane)},
        });
    }
    return {
        {QStringLiteral("growths"), growthList},
        {QStringLiteral("layers"), layerList},
        {QStringLiteral("segments"), segmentList},
    };
}

} // namespace core
