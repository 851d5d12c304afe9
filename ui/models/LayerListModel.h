// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "ui/models/NumberedListModel.h"

namespace ui {

/// Item model of the document's sculpt layers in their order. Names and mutes are changed through
/// the session, as steps of undo.
class LayerListModel : public NumberedListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole, ///< int
        MutedRole, ///< bool; can be set
        ActiveRole, ///< bool: tools carve this one
        SoloRole, ///< bool; can be set
        CarvesRole, ///< bool: neither muted nor left out
        HidesRole, ///< double: how much of what it carves is hidden in 3D (LayerLooks)
    };

    explicit LayerListModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

protected:
    [[nodiscard]] std::vector<int> numbers(const core::Document& document) const override;

private:
    [[nodiscard]] const core::SculptLayer* layerAt(const QModelIndex& index) const;
};

} // namespace ui
