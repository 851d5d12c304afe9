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

/// Splits the islands of a segment that have at least a chosen size into segments of their own, and
/// says before how many that would be. The largest island always stays with the segment.
class SplitIslandsDialog : public LabelLookDialog {
    Q_OBJECT

public:
    explicit SplitIslandsDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Opens the dialog for a segment.
    void ask(int label);

private:
    void count(const LabelFetch::Planes& planes) override;
    void forgetFound() override { m_sizes.reset(); }
    void showState() override;
    void carryOut();
    [[nodiscard]] core::SplitIslands chosen() const;

    /// Number of voxels of each island, largest first; none while they are being counted, or if
    /// that failed.
    std::optional<std::vector<std::int64_t>> m_sizes;
    QDoubleSpinBox* m_mm3;
    QLabel* m_result;
    QPushButton* m_apply;
};

} // namespace ui
