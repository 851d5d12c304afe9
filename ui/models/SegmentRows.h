// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QModelIndex>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace ui {

/// What item models have in common that have a row per segment, in the document's order.
/// @tparam Model QAbstractListModel or QAbstractTableModel
template <class Model> class SegmentRows : public Model {
public:
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : int(m_labels.size());
    }

protected:
    using Model::Model;

    /// The labels of the rows, as the views were last told.
    [[nodiscard]] const std::vector<int>& labels() const { return m_labels; }
    /// Forgets the rows of another session.
    void clearRows()
    {
        Model::beginResetModel();
        m_labels.clear();
        Model::endResetModel();
    }
    /// Tells the views which rows went and came; those in front of the first that differs stay.
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
