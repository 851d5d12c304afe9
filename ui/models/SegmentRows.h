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
    /// Follows added and removed segments. All rows from the first difference on are removed and
    /// inserted again; those before it stay.
    /// @param document null: none is open
    void followSegments(const core::Document* document)
    {
        std::vector<int> present;
        if (document) {
            for (const core::Segment& segment : document->segments)
                present.push_back(segment.label);
        }
        const auto apart =
            std::mismatch(m_labels.begin(), m_labels.end(), present.begin(), present.end());
        const int same = int(apart.first - m_labels.begin());
        if (same < int(m_labels.size())) {
            Model::beginRemoveRows({}, same, int(m_labels.size()) - 1);
            m_labels.resize(std::size_t(same));
            Model::endRemoveRows();
        }
        if (same < int(present.size())) {
            Model::beginInsertRows({}, same, int(present.size()) - 1);
            m_labels = std::move(present);
            Model::endInsertRows();
        }
    }

private:
    std::vector<int> m_labels;
};

} // namespace ui
