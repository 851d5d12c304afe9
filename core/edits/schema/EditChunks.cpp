// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditChunks.h"

#include "core/edits/schema/EntryLists.h"

#include <QJsonArray>
#include <QJsonObject>

#include <cmath>

namespace core::editFields {

namespace {

constexpr WholeNumber ownerLabel{1, 255};
constexpr double lastBrick = 4294967295.0;

} // namespace

QJsonValue ChunkOwnerList::write(const Value& value) const
{
    return writeEach(value, [](const ChunkOwner& owner) {
        return QJsonObject{{QStringLiteral("label"), owner.label},
            {QStringLiteral("voxels"), inBase64(owner.voxels)}};
    });
}

QString ChunkOwnerList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, QStringLiteral("must be a list of segments"),
        [](const QJsonValue& entry, ChunkOwner& owner) {
            const QJsonObject object = entry.toObject();
            const bool sound =
                ownerLabel.read(object[QStringLiteral("label")], owner.label).isEmpty()
                && fromBase64(object[QStringLiteral("voxels")], owner.voxels) && object.size() == 2;
            return sound ? QString()
                         : QStringLiteral("has no label and voxels, or more than these");
        });
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

QJsonValue PackedBytes::write(const Value& value) const
{
    return inBase64(value);
}

QString PackedBytes::read(const QJsonValue& json, Value& value) const
{
    return fromBase64(json, value) ? QString() : QStringLiteral("must be bytes in base 64");
}

QString PackedBytes::check(const Value& value) const
{
    return value.isEmpty() ? QStringLiteral("must not be empty") : QString();
}

QJsonValue BrickList::write(const Value& value) const
{
    return writeEach(value, [](std::int64_t brick) { return QJsonValue(qint64(brick)); });
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
    return ascends(value) ? QString() : QStringLiteral("must ascend");
}

} // namespace core::editFields
