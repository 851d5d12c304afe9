// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QModelIndex>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace ui {

/// Base of item models with one row per segment, in the document's order.
/// @tparam Model QAbstractListModel or QAbstractTableModel
template <class Model> class SegmentRows : public Model {
public:
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : int(m_labels.size());
    }

protected:
    using Model::Model;

    /// Labels of the rows as the views know them.
    [[nodiscard]] const std::vector<int>& labels() const { return m_labels; }
    /// Removes all rows. Call it when another session is opened.
    void clearRows()
    {
        Model::beginResetModel();
        m_labels.clear();
        Model::endResetModel();
    }
    /// Follows segments that were added, removed or moved. The rows of all others stay what they
    /// are, so that views keep which of them is the current one.
    /// @param document null: none is open
    void followSegments(const core::Document* document)
    {
        // A view whose current row goes makes another segment the active one meanwhile, which leads
        // back to here.
        if (std::exchange(m_isFollowing, true))
            return;
        std::vector<int> present;
        if (document) {
            for (const core::Segment& segment : document->segments)
                present.push_back(segment.label);
        }
        removeOthers(present);
        for (std::size_t place = 0; place < present.size(); ++place)
            putAt(place, present[place]);
        m_isFollowing = false;
    }

private:
    void removeOthers(const std::vector<int>& present)
    {
        for (std::size_t place = m_labels.size(); place-- > 0;) {
            if (std::find(present.begin(), present.end(), m_labels[place]) != present.end())
                continue;
            Model::beginRemoveRows({}, int(place), int(place));
            m_labels.erase(m_labels.begin() + std::ptrdiff_t(place));
            Model::endRemoveRows();
        }
    }
    /// The rows before are right already.
    void putAt(std::size_t place, int label)
    {
        const auto wanted = m_labels.begin() + std::ptrdiff_t(place);
        const auto found = std::find(wanted, m_labels.end(), label);
        if (found == m_labels.end()) {
            Model::beginInsertRows({}, int(place), int(place));
            m_labels.insert(wanted, label);
            Model::endInsertRows();
        } else if (found != wanted) {
            const int from = int(found - m_labels.begin());
            Model::beginMoveRows({}, from, from, {}, int(place));
            std::rotate(wanted, found, found + 1);
            Model::endMoveRows();
        }
    }

    std::vector<int> m_labels;
    bool m_isFollowing = false;
};

} // namespace ui
