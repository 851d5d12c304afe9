// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <QDialog>

#include <memory>
#include <optional>
#include <vector>

class QListWidget;
class QPushButton;
class QRadioButton;

namespace core {
struct ReadImport;
}

namespace ui {

class MaskImporter;

/// Asks what to do when segments of an imported mask overlap. There are two answers: keep the
/// overlaps, so that each segment keeps all its voxels and the segments are spread over several
/// label planes; or flatten the mask, so that each voxel goes to one segment. For the second answer
/// the user puts the overlapping segments in order of precedence, and the dialog says for each
/// overlapping pair how much goes to which segment.
class MaskOrderDialog : public QDialog {
    Q_OBJECT

public:
    /// @param read the mask as it was read; it has overlaps
    MaskOrderDialog(const core::ReadImport& read, const core::VolumeGeometry& geometry,
        QWidget* parent = nullptr);
    ~MaskOrderDialog() override;

    /// The order that the user chose, in the form of ImportMask::ahead. None if the overlaps are
    /// kept, or if the order is that of the file.
    [[nodiscard]] std::optional<std::vector<int>> ahead() const;
    /// The label planes of the segments, in the form of ImportMask::planes. None if the mask is
    /// flattened.
    [[nodiscard]] std::optional<std::vector<int>> planes() const;

private:
    void move(int by);
    void showState();

    std::unique_ptr<core::ReadImport> m_read;
    core::VolumeGeometry m_geometry;
    QRadioButton* m_keep;
    QRadioButton* m_flatten;
    /// The widgets for the order; shown while "Each voxel goes to one segment" is chosen.
    QWidget* m_ordering;
    /// The segments that overlap; the first one takes precedence over all others.
    QListWidget* m_order;
    QListWidget* m_given; ///< one sentence for each overlapping pair
    QPushButton* m_up;
    QPushButton* m_down;
};

/// From now on opens this dialog over @p window whenever @p importer has read a mask whose segments
/// overlap.
void askForOrderOf(MaskImporter& importer, QWidget& window);

} // namespace ui
