// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitle.h"

#include <optional>
#include <utility>

namespace core::rowWords {

// Titles of rows that change entries of the document's lists. They name every difference: "Rename
// segment 1 to 'Bone', recolour it, lock it".

/// Collects what was done, in order. The first part also names the object.
class Deeds {
public:
    /// @param alone "Lock segment 'A'", @param further "lock it"
    void add(RowTitle alone, RowTitle further)
    {
        if (m_title.code == RowTitleCode::Nothing)
            m_title = std::move(alone);
        else
            m_title.then.push_back(std::move(further));
    }
    [[nodiscard]] const RowTitle& title() const { return m_title; }

private:
    RowTitle m_title;
};

template <class T> [[nodiscard]] bool differs(const std::optional<T>& value, const T* before)
{
    return value && (!before || *before != *value);
}

} // namespace core::rowWords
