// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonValue>
#include <QString>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <vector>

namespace core::editFields {

// What all list fields share: each function processes a list entry by entry, with a function of the
// caller for one entry. A reason for refusal names the entry, counted from 1.

[[nodiscard]] inline Clause atEntry(std::size_t place, const Clause& reason)
{
    return Clause::saying("entry %1: %2", place + 1, reason);
}

/// @param write JSON of one entry
template <class Entry, class Write>
[[nodiscard]] QJsonValue writeEach(const std::vector<Entry>& value, const Write& write)
{
    QJsonArray array;
    for (const Entry& entry : value)
        array.append(write(entry));
    return array;
}

/// @param noList the reason if the JSON is not a list
/// @param read JSON of one entry, into that entry: the reason, or empty
template <class Entry, class Read>
[[nodiscard]] Clause readEach(
    const QJsonValue& json, std::vector<Entry>& value, const Clause& noList, const Read& read)
{
    if (!json.isArray())
        return noList;
    const QJsonArray array = json.toArray();
    value.assign(std::size_t(array.size()), Entry());
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (const Clause reason = read(array[qsizetype(i)], value[i]); !reason.isEmpty())
            return atEntry(i, reason);
    }
    return {};
}

/// @param check of one entry: the reason, or empty
template <class Entry, class Check>
[[nodiscard]] Clause checkEach(const std::vector<Entry>& value, const Check& check)
{
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (const Clause reason = check(value[i]); !reason.isEmpty())
            return atEntry(i, reason);
    }
    return {};
}

template <class Entry, class Round>
[[nodiscard]] std::vector<Entry> roundEach(const std::vector<Entry>& value, const Round& round)
{
    std::vector<Entry> result;
    result.reserve(value.size());
    for (const Entry& entry : value)
        result.push_back(round(entry));
    return result;
}

/// The first reason that is not empty; empty if all are.
[[nodiscard]] inline Clause firstOf(std::initializer_list<Clause> reasons)
{
    const auto said = std::find_if(
        reasons.begin(), reasons.end(), [](const Clause& reason) { return !reason.isEmpty(); });
    return said == reasons.end() ? Clause() : *said;
}

/// Bytes as text, as a list's objects hold voxels.
[[nodiscard]] inline QString inBase64(const QByteArray& bytes)
{
    return QString::fromLatin1(bytes.toBase64());
}

/// @return whether it was such a text
[[nodiscard]] inline bool fromBase64(const QJsonValue& json, QByteArray& bytes)
{
    const auto decoded = QByteArray::fromBase64Encoding(json.toString().toLatin1(),
        QByteArray::Base64Encoding | QByteArray::AbortOnBase64DecodingErrors);
    bytes = decoded.decoded;
    return bool(decoded);
}

/// Whether each number is greater than the one before.
template <class Number> [[nodiscard]] bool ascends(const std::vector<Number>& value)
{
    return std::adjacent_find(value.begin(), value.end(), std::greater_equal<>()) == value.end();
}

} // namespace core::editFields
