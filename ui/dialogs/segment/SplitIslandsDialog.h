// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/splitting/SplitIslands.h"
#include "ui/dialogs/segment/LabelLookDialog.h"

#include <cstdint>
#include <optional>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace ui {

/// Asks from which size on the islands of a segment become segments of their own, and says how many
/// these are.
class SplitIslandsDialog : public LabelLookDialog {
    Q_OBJECT

public:
    explicit SplitIslandsDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    void ask(int label);

private:
    void count(const LabelFetch::Planes& planes) override;
    void forgetFound() override { m_sizes.reset(); }
    void showState() override;
    void carryOut();
    [[nodiscard]] core::SplitIslands chosen() const;

    /// Voxels of each island, from the largest down; none: they are being counted, or cannot be.
    std::optional<std::vector<std::int64_t>> m_sizes;
    QDoubleSpinBox* m_mm3;
    QLabel* m_result;
    QPushButton* m_apply;
};

} // namespace ui
