// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "ui/models/SegmentRows.h"

#include <QAbstractListModel>

namespace ui {

class Workspace;

/// Item model of the document's segments in their order. Names, colours and codes are changed
/// through the session, as steps of undo; visibility is display state.
class SegmentListModel : public SegmentRows<QAbstractListModel> {
    Q_OBJECT

public:
    enum Role {
        LabelRole = Qt::UserRole, ///< int
        ColourRole, ///< QColor; can be set
        VisibleRole, ///< bool; can be set
        AloneRole, ///< bool: shown, and no other one; setting it, to whatever, switches
                   ///< (ViewSteps::showAlone)
        LockedRole, ///< bool; can be set
        ProtectedRole, ///< bool: no tool carves it; can be set
        VolumeRole, ///< QString: "9.8 mL", "—" while empty
        CodeRole, ///< QStringList {scheme, value, meaning}, empty if not coded; can be set
        CodeTextRole, ///< QString: the meaning, or "not coded yet"
        FollowsRole, ///< QString: "follows 300 … 3071 HU"; empty: it follows no interval
        UnwrittenRole, ///< bool: its surface was changed and not written back
        ActiveRole, ///< bool
    };

    explicit SegmentListModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

    [[nodiscard]] int rowOf(int label) const; ///< -1: none

private:
    void refresh();
    [[nodiscard]] const core::Segment* segmentAt(const QModelIndex& index) const;
    [[nodiscard]] QString followsText(const core::Segment& segment) const;
    bool change(const core::Segment& segment, const QVariant& value, int role);

    Workspace& m_workspace;
};

} // namespace ui
