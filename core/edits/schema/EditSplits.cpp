// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditSplits.h"

#include "core/edits/schema/EntryLists.h"

#include <QJsonObject>

namespace core::editFields {

QJsonValue SplitPartList::write(const Value& value) const
{
    return writeEach(value, [](const SplitPart& part) {
        return QJsonObject{{QStringLiteral("name"), Text().write(part.name)},
            {QStringLiteral("color"), Colour().write(part.rgb)}};
    });
}

Clause SplitPartList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of segments"),
        [](const QJsonValue& entry, SplitPart& part) {
            const QJsonObject object = entry.toObject();
            const Clause reason = firstOf({Text().read(object[QStringLiteral("name")], part.name),
                Colour().read(object[QStringLiteral("color")], part.rgb)});
            return object.size() == 2 || !reason.isEmpty()
                ? reason
                : Clause::saying("has no name and color, or more than these");
        });
}

Clause SplitPartList::check(const Value& value) const
{
    constexpr std::size_t most = 255;
    if (value.empty() || value.size() > most)
        return Clause::saying("needs 1 to %1 entries", most);
    return checkEach(value, [](const SplitPart& part) {
        return firstOf({Text().check(part.name), Colour().check(part.rgb)});
    });
}

} // namespace core::editFields
