// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditMasks.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace core::editFields {

namespace {

constexpr int longestFileName = 4096;
constexpr int mostSegments = 255;
constexpr int longestSide = 32768;

} // namespace

QString FileName::read(const QJsonValue& json, Value& value) const
{
    return Text().read(json, value);
}

QString FileName::check(const Value& value) const
{
    if (value.isEmpty())
        return QStringLiteral("must not be empty");
    if (value.size() > longestFileName)
        return QStringLiteral("is longer than %1 characters").arg(longestFileName);
    const bool sound = std::none_of(
        value.begin(), value.end(), [](QChar character) { return character.unicode() == 0; });
    return sound ? QString() : QStringLiteral("is not the name of a file");
}

QJsonValue SegmentReference::write(const Value& value) const
{
    return value.number ? QJsonValue(*value.number) : QJsonValue(value.name);
}

QString SegmentReference::read(const QJsonValue& json, Value& value) const
{
    if (json.isString()) {
        value.name = json.toString();
        return {};
    }
    const QString reason = WholeNumber{1, mostSegments}.read(json, value.number.emplace());
    return reason.isEmpty() ? reason
                            : QStringLiteral("must be the name or the number of a segment");
}

QString SegmentReference::check(const Value& value) const
{
    return value.number ? WholeNumber{1, mostSegments}.check(*value.number)
                        : Text().check(value.name);
}

QJsonValue GridSize::write(const Value& value) const
{
    return QJsonArray{value.x, value.y, value.z};
}

QString GridSize::read(const QJsonValue& json, Value& value) const
{
    const QJsonArray sides = json.toArray();
    bool sound = sides.size() == 3;
    for (int axis = 0; sound && axis < 3; ++axis)
        sound = WholeNumber().read(sides[axis], value[axis]).isEmpty();
    return sound ? QString() : QStringLiteral("must be three whole numbers [x, y, z]");
}

QString GridSize::check(const Value& value) const
{
    for (int axis = 0; axis < 3; ++axis) {
        if (const QString reason = WholeNumber{1, longestSide}.check(value[axis]);
            !reason.isEmpty())
            return reason;
    }
    return {};
}

QJsonValue ImportedSegmentList::write(const Value& value) const
{
    QJsonArray array;
    for (const ImportedSegment& segment : value) {
        array.append(QJsonObject{{QStringLiteral("name"), Text().write(segment.name)},
            {QStringLiteral("color"), Colour().write(segment.rgb)},
            {QStringLiteral("code"), Code().write(segment.code)},
            {QStringLiteral("voxels"), QString::fromLatin1(segment.voxels.toBase64())}});
    }
    return array;
}

QString ImportedSegmentList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of segments");
    const QJsonArray array = json.toArray();
    value.assign(std::size_t(array.size()), {});
    for (int i = 0; i < array.size(); ++i) {
        const QJsonObject object = array[i].toObject();
        ImportedSegment& segment = value[std::size_t(i)];
        QString reason = Text().read(object[QStringLiteral("name")], segment.name);
        if (reason.isEmpty())
            reason = Colour().read(object[QStringLiteral("color")], segment.rgb);
        if (reason.isEmpty())
            reason = Code().read(object[QStringLiteral("code")], segment.code);
        const auto decoded =
            QByteArray::fromBase64Encoding(object[QStringLiteral("voxels")].toString().toLatin1(),
                QByteArray::Base64Encoding | QByteArray::AbortOnBase64DecodingErrors);
        if (reason.isEmpty() && (!decoded || object.size() != 4))
            reason = QStringLiteral("has no name, color, code and voxels, or more than these");
        if (!reason.isEmpty())
            return QStringLiteral("entry %1: %2").arg(i + 1).arg(reason);
        segment.voxels = decoded.decoded;
    }
    return {};
}

QString ImportedSegmentList::check(const Value& value) const
{
    if (value.empty() || value.size() > std::size_t(mostSegments))
        return QStringLiteral("needs 1 to %1 entries").arg(mostSegments);
    for (std::size_t i = 0; i < value.size(); ++i) {
        const ImportedSegment& segment = value[i];
        for (const QString& reason :
            {Text().check(segment.name), Colour().check(segment.rgb), Code().check(segment.code)}) {
            if (!reason.isEmpty())
                return QStringLiteral("entry %1: %2").arg(i + 1).arg(reason);
        }
    }
    return {};
}

} // namespace core::editFields
