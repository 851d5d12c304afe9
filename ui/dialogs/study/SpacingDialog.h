// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/StudyListing.h"

#include <QDialog>

#include <array>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace ui {

/// Asks for the voxel spacing of pictures that do not state it fully; starts with what they do
/// state.
class SpacingDialog : public QDialog {
    Q_OBJECT

public:
    explicit SpacingDialog(const core::SeriesEntry& entry, QWidget* parent = nullptr);

    /// The answer as core::withRepair() takes it ("spacing=0.5x0.5x2").
    [[nodiscard]] QString repair() const;

private:
    void buildFields(const glm::dvec3& saidMm);
    void showExtent();

    const glm::ivec3 m_size;
    std::array<QDoubleSpinBox*, 3> m_fields{};
    QLabel* m_extent = nullptr;
    QPushButton* m_open = nullptr;
};

} // namespace ui
