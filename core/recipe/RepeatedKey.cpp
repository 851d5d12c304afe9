// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RepeatedKey.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <set>
#include <vector>

namespace core {

namespace {

/// Behind the string that begins at @p start.
qsizetype endOfString(const QByteArray& json, qsizetype start)
{
    qsizetype at = start + 1;
    while (at < json.size() && json[at] != '"')
        at += json[at] == '\\' ? 2 : 1;
    return at + 1;
}

/// "a" and "\u0061" are one key.
QString unescaped(const QByteArray& quoted)
{
    return QJsonDocument::fromJson('[' + quoted + ']').array().at(0).toString();
}

bool isKey(const QByteArray& json, qsizetype end)
{
    while (end < json.size() && QByteArrayView(" \t\r\n").contains(json[end]))
        ++end;
    return end < json.size() && json[end] == ':';
}

} // namespace

std::optional<RepeatedKey> repeatedKey(const QByteArray& json)
{
    std::vector<std::set<QString>> open; // keys of the objects around
    for (qsizetype at = 0; at < json.size();) {
        switch (json[at]) {
        case '{':
            open.emplace_back();
            ++at;
            break;
        case '}':
            if (!open.empty())
                open.pop_back();
            ++at;
            break;
        case '"': {
            const qsizetype end = endOfString(json, at);
            if (!open.empty() && isKey(json, end)) {
                const QString key = unescaped(json.mid(at, end - at));
                if (!open.back().insert(key).second)
                    return RepeatedKey{key, int(json.left(at).count('\n')) + 1};
            }
            at = end;
            break;
        }
        default:
            ++at;
        }
    }
    return std::nullopt;
}

} // namespace core
