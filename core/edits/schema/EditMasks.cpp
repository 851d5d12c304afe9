// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditMasks.h"

#include "core/edits/schema/EntryLists.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace core::editFields {

namespace {

constexpr int longestFileName = 4096;
constexpr int mostSegments = 255;
constexpr int longestSide = 32768;

} // namespace

Clause FileName::read(const QJsonValue& json, Value& value) const
{
    return Text().read(json, value);
}

Clause FileName::check(const Value& value) const
{
    if (value.isEmpty())
        return Clause::saying("must not be empty");
    if (value.size() > longestFileName)
        return Clause::saying("is longer than %1 characters", longestFileName);
    const bool sound = std::none_of(
        value.begin(), value.end(), [](QChar character) { return character.unicode() == 0; });
    return sound ? Clause() : Clause::saying("is not the name of a file");
}

QJsonValue SegmentReference::write(const Value& value) const
{
    return value.number ? QJsonValue(*value.number) : QJsonValue(value.name);
}

Clause SegmentReference::read(const QJsonValue& json, Value& value) const
{
    if (json.isString()) {
        value.name = json.toString();
        return {};
    }
    const Clause reason = WholeNumber{1, mostSegments}.read(json, value.number.emplace());
    return reason.isEmpty() ? reason
                            : Clause::saying("must be the name or the number of a segment");
}

Clause SegmentReference::check(const Value& value) const
{
    return value.number ? WholeNumber{1, mostSegments}.check(*value.number)
                        : Text().check(value.name);
}

QJsonValue GridSize::write(const Value& value) const
{
    return QJsonArray{value.x, value.y, value.z};
}

Clause GridSize::read(const QJsonValue& json, Value& value) const
{
    const QJsonArray sides = json.toArray();
    bool sound = sides.size() == 3;
    for (int axis = 0; sound && axis < 3; ++axis)
        sound = WholeNumber().read(sides[axis], value[axis]).isEmpty();
    return sound ? Clause() : Clause::saying("must be three whole numbers [x, y, z]");
}

Clause GridSize::check(const Value& value) const
{
    for (int axis = 0; axis < 3; ++axis) {
        if (const Clause reason = WholeNumber{1, longestSide}.check(value[axis]); !reason.isEmpty())
            return reason;
    }
    return {};
}

QJsonValue ImportedSegmentList::write(const Value& value) const
{
    return writeEach(value, [](const ImportedSegment& segment) {
        return QJsonObject{{QStringLiteral("name"), Text().write(segment.name)},
            {QStringLiteral("color"), Colour().write(segment.rgb)},
            {QStringLiteral("code"), Code().write(segment.code)},
            {QStringLiteral("voxels"), inBase64(segment.voxels)}};
    });
}

Clause ImportedSegmentList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of segments"),
        [](const QJsonValue& entry, ImportedSegment& segment) {
            const QJsonObject object = entry.toObject();
            const Clause reason =
                firstOf({Text().read(object[QStringLiteral("name")], segment.name),
                    Colour().read(object[QStringLiteral("color")], segment.rgb),
                    Code().read(object[QStringLiteral("code")], segment.code)});
            const bool whole =
                fromBase64(object[QStringLiteral("voxels")], segment.voxels) && object.size() == 4;
            return whole || !reason.isEmpty()
                ? reason
                : Clause::saying("has no name, color, code and voxels, or more than these");
        });
}

Clause ImportedSegmentList::check(const Value& value) const
{
    if (value.empty() || value.size() > std::size_t(mostSegments))
        return Clause::saying("needs 1 to %1 entries", mostSegments);
    return checkEach(value, [](const ImportedSegment& segment) {
        return firstOf(
            {Text().check(segment.name), Colour().check(segment.rgb), Code().check(segment.code)});
    });
}

QJsonValue EntryOrder::write(const Value& value) const
{
    return writeEach(value, [](int place) { return QJsonValue(place); });
}

Clause EntryOrder::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of places"),
        [](const QJsonValue& entry, int& place) {
            return WholeNumber{1, mostSegments}.read(entry, place);
        });
}

Clause EntryOrder::check(const Value& value) const
{
    if (value.empty() || value.size() > std::size_t(mostSegments))
        return Clause::saying("needs 1 to %1 entries", mostSegments);
    Value sorted = value;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        return Clause::saying("names a place twice");
    return checkEach(value, [](int place) { return WholeNumber{1, mostSegments}.check(place); });
}

QJsonValue PlaneList::write(const Value& value) const
{
    return EntryOrder{}.write(value);
}

Clause PlaneList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of planes"),
        [](const QJsonValue& entry, int& plane) {
            return WholeNumber{0, mostLabelPlanes - 1}.read(entry, plane);
        });
}

Clause PlaneList::check(const Value& value) const
{
    if (value.empty() || value.size() > std::size_t(mostSegments))
        return Clause::saying("needs 1 to %1 entries", mostSegments);
    return checkEach(value, [](int plane) {
        return WholeNumber{0, mostLabelPlanes - 1}.check(plane);
    });
}

} // namespace core::editFields
