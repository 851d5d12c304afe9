// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/ReadImport.h"
#include "core/volume/VolumeGeometry.h"

#include <QDialog>

#include <optional>
#include <vector>

class QListWidget;
class QPushButton;
class QRadioButton;

namespace ui {

class MaskImporter;

/// Asks what becomes of voxels that several segments of a mask have: each segment keeps its own, in
/// further label planes, or each voxel goes to one of them. For the latter it asks which segments
/// go before which others, and tells for each pair how much goes to which.
class MaskOrderDialog : public QDialog {
    Q_OBJECT

public:
    /// @param read has overlaps
    MaskOrderDialog(const core::ReadImport& read, const core::VolumeGeometry& geometry,
        QWidget* parent = nullptr);

    /// ImportMask::ahead as chosen; none: the order of the file, or the overlaps are kept.
    [[nodiscard]] std::optional<std::vector<int>> ahead() const;
    /// ImportMask::planes as chosen; none: each voxel goes to one segment.
    [[nodiscard]] std::optional<std::vector<int>> planes() const;

private:
    void move(int by);
    void showState();

    core::ReadImport m_read;
    core::VolumeGeometry m_geometry;
    QRadioButton* m_keep;
    QRadioButton* m_flatten;
    QWidget* m_ordering; ///< what the second answer needs
    QListWidget* m_order; ///< of the segments that overlap, the first one foremost
    QListWidget* m_given; ///< a sentence for each pair
    QPushButton* m_up;
    QPushButton* m_down;
};

/// Lets the dialog ask whenever the segments of a mask overlap that the importer has read.
void askForOrderOf(MaskImporter& importer, QWidget& window);

} // namespace ui
