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

Clause ChunkOwnerList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of segments"),
        [](const QJsonValue& entry, ChunkOwner& owner) {
            const QJsonObject object = entry.toObject();
            const bool sound =
                ownerLabel.read(object[QStringLiteral("label")], owner.label).isEmpty()
                && fromBase64(object[QStringLiteral("voxels")], owner.voxels) && object.size() == 2;
            return sound ? Clause() : Clause::saying("has no label and voxels, or more than these");
        });
}

Clause ChunkOwnerList::check(const Value& value) const
{
    if (value.empty())
        return Clause::saying("needs at least one entry");
    int last = 0;
    for (const ChunkOwner& owner : value) {
        if (const Clause reason = ownerLabel.check(owner.label); !reason.isEmpty())
            return reason;
        if (owner.label <= last)
            return Clause::saying("must ascend");
        last = owner.label;
    }
    return {};
}

QJsonValue PackedBytes::write(const Value& value) const
{
    return inBase64(value);
}

Clause PackedBytes::read(const QJsonValue& json, Value& value) const
{
    return fromBase64(json, value) ? Clause() : Clause::saying("must be bytes in base 64");
}

Clause PackedBytes::check(const Value& value) const
{
    return value.isEmpty() ? Clause::saying("must not be empty") : Clause();
}

QJsonValue BrickList::write(const Value& value) const
{
    return writeEach(value, [](std::int64_t brick) { return QJsonValue(qint64(brick)); });
}

Clause BrickList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return Clause::saying("must be a list of bricks");
    value.clear();
    for (const QJsonValue& entry : json.toArray()) {
        const double number = entry.toDouble(-1.0);
        if (number < 0.0 || number > lastBrick || number != std::floor(number))
            return Clause::saying("must be numbers of bricks, 0 or more");
        value.push_back(std::int64_t(number));
    }
    return {};
}

Clause BrickList::check(const Value& value) const
{
    if (!value.empty() && (value.front() < 0 || double(value.back()) > lastBrick))
        return Clause::saying("must be numbers of bricks, 0 or more");
    return ascends(value) ? Clause() : Clause::saying("must ascend");
}

} // namespace core::editFields
