// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <optional>

namespace core::rowWords {

// Names of rows that change what a list of the document says: all that is different then, "Rename
// segment 1 to 'Bone', recolour it, lock it".

/// What was done, one after the other; the first says to what.
class Deeds {
public:
    /// @param alone "Lock segment 'A'", @param further "lock it"
    void add(const QString& alone, const QString& further)
    {
        m_deeds += m_deeds.isEmpty() ? alone : further;
    }
    [[nodiscard]] QString text() const { return m_deeds.join(QStringLiteral(", ")); }

private:
    QStringList m_deeds;
};

template <class T> [[nodiscard]] bool differs(const std::optional<T>& value, const T* before)
{
    return value && (!before || *before != *value);
}

} // namespace core::rowWords
