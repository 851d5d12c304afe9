// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QAbstractListModel>

namespace ui {

class Workspace;

/// The document's sculpt layers in their order. Names and mutes are changed through the session, as
/// steps of undo.
class LayerListModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole, ///< int
        MutedRole, ///< bool; can be set
        ActiveRole, ///< bool: tools carve this one
        SoloRole, ///< bool; can be set
        CarvesRole, ///< bool: neither muted nor left out
    };

    explicit LayerListModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

    [[nodiscard]] int rowOf(int layer) const; ///< -1: none

private:
    void refresh();
    [[nodiscard]] const core::SculptLayer* layerAt(const QModelIndex& index) const;

    Workspace& m_workspace;
    std::vector<int> m_ids; ///< what the views were last told
};

} // namespace ui
