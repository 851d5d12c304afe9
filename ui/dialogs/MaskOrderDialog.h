// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/ReadImport.h"
#include "core/volume/VolumeGeometry.h"

#include <QDialog>

#include <optional>
#include <vector>

class QListWidget;
class QPushButton;

namespace ui {

class MaskImporter;

/// Asks which segments of a mask go before which others where they overlap, and tells for each
/// pair how much goes to which.
class MaskOrderDialog : public QDialog {
    Q_OBJECT

public:
    /// @param read has overlaps
    MaskOrderDialog(const core::ReadImport& read, const core::VolumeGeometry& geometry,
        QWidget* parent = nullptr);

    /// ImportMask::ahead as chosen; none: the order of the file.
    [[nodiscard]] std::optional<std::vector<int>> ahead() const;

private:
    void move(int by);
    void showState();

    core::ReadImport m_read;
    core::VolumeGeometry m_geometry;
    QListWidget* m_order; ///< of the segments that overlap, the first one foremost
    QListWidget* m_given; ///< a sentence for each pair
    QPushButton* m_up;
    QPushButton* m_down;
};

/// Lets the dialog ask whenever the segments of a mask overlap that the importer has read.
void askForOrderOf(MaskImporter& importer, QWidget& window);

} // namespace ui
