// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditChunks.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace core::editFields {

namespace {

constexpr WholeNumber ownerLabel{1, 255};
constexpr double lastBrick = 4294967295.0;

} // namespace

QJsonValue ChunkOwnerList::write(const Value& value) const
{
    QJsonArray array;
    for (const ChunkOwner& owner : value)
        array.append(QJsonObject{{QStringLiteral("label"), owner.label},
            {QStringLiteral("voxels"), QString::fromLatin1(owner.voxels.toBase64())}});
    return array;
}

QString ChunkOwnerList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of segments");
    value.clear();
    for (const QJsonValue& entry : json.toArray()) {
        const QJsonObject object = entry.toObject();
        ChunkOwner& owner = value.emplace_back();
        const auto decoded =
            QByteArray::fromBase64Encoding(object[QStringLiteral("voxels")].toString().toLatin1(),
                QByteArray::Base64Encoding | QByteArray::AbortOnBase64DecodingErrors);
        if (!ownerLabel.read(object[QStringLiteral("label")], owner.label).isEmpty() || !decoded
            || object.size() != 2)
            return QStringLiteral("entry %1: has no label and voxels, or more than these")
                .arg(value.size());
        owner.voxels = decoded.decoded;
    }
    return {};
}

QString ChunkOwnerList::check(const Value& value) const
{
    if (value.empty())
        return QStringLiteral("needs at least one entry");
    int last = 0;
    for (const ChunkOwner& owner : value) {
        if (const QString reason = ownerLabel.check(owner.label); !reason.isEmpty())
            return reason;
        if (owner.label <= last)
            return QStringLiteral("must ascend");
        last = owner.label;
    }
    return {};
}

QJsonValue BrickList::write(const Value& value) const
{
    QJsonArray array;
    for (const std::int64_t brick : value)
        array.append(qint64(brick));
    return array;
}

QString BrickList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of bricks");
    value.clear();
    for (const QJsonValue& entry : json.toArray()) {
        const double number = entry.toDouble(-1.0);
        if (number < 0.0 || number > lastBrick || number != std::floor(number))
            return QStringLiteral("must be numbers of bricks, 0 or more");
        value.push_back(std::int64_t(number));
    }
    return {};
}

QString BrickList::check(const Value& value) const
{
    if (!value.empty() && (value.front() < 0 || double(value.back()) > lastBrick))
        return QStringLiteral("must be numbers of bricks, 0 or more");
    if (std::adjacent_find(value.begin(), value.end(), std::greater_equal<>()) != value.end())
        return QStringLiteral("must ascend");
    return {};
}

} // namespace core::editFields
