// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditPlanes.h"

#include "core/edits/schema/EntryLists.h"
#include "core/morphology/planes/PlaneSketch.h"

#include <QJsonObject>

namespace core::editFields {

QJsonValue DrawnPlaneList::write(const Value& value) const
{
    return writeEach(value, [this](const DrawnPlane& plane) {
        return QJsonObject{{QStringLiteral("placeLps"), place.write(plane.placeLps)},
            {QStringLiteral("normalLps"), normal.write(plane.normalLps)}};
    });
}

Clause DrawnPlaneList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of planes"),
        [this](const QJsonValue& entry, DrawnPlane& plane) {
            const QJsonObject object = entry.toObject();
            const Clause reason =
                firstOf({place.read(object[QStringLiteral("placeLps")], plane.placeLps),
                    normal.read(object[QStringLiteral("normalLps")], plane.normalLps)});
            return object.size() == 2 || !reason.isEmpty()
                ? reason
                : Clause::saying("has more than a place and a normal");
        });
}

Clause DrawnPlaneList::check(const Value& value) const
{
    if (value.size() < 2 || value.size() > PlaneSketch::mostPlanes)
        return Clause::saying("needs 2 to %1 entries", PlaneSketch::mostPlanes);
    return checkEach(value, [this](const DrawnPlane& plane) {
        return firstOf({place.check(plane.placeLps), normal.check(plane.normalLps)});
    });
}

DrawnPlaneList::Value DrawnPlaneList::rounded(const Value& value) const
{
    return roundEach(value, [this](const DrawnPlane& plane) {
        return DrawnPlane{.placeLps = place.rounded(plane.placeLps),
            .normalLps = normal.rounded(plane.normalLps)};
    });
}

} // namespace core::editFields
