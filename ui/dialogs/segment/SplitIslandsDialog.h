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

class PreviewRow;

/// Splits the islands of a segment that have at least a chosen size into segments of their own, and
/// says before how many that would be; all views preview them. The largest island always stays with
/// the segment.
class SplitIslandsDialog : public LabelLookDialog {
    Q_OBJECT

public:
    explicit SplitIslandsDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Opens the dialog for a segment.
    void ask(int label);

private:
    void count(const LabelFetch::Planes& planes) override;
    void forgetFound() override;
    void showState() override;
    void follow(); ///< updates the preview to what is chosen
    void carryOut();
    [[nodiscard]] core::SplitIslands chosen() const;
    /// The same with the segments to be made, whose colours the preview needs, where it is known
    /// how many there will be.
    [[nodiscard]] core::SplitIslands previewed() const;
    /// How many islands beside the largest are large enough; none until they are counted.
    [[nodiscard]] std::optional<std::int64_t> others() const;

    /// Number of voxels of each island, largest first; none while they are being counted, or if
    /// that failed.
    std::optional<std::vector<std::int64_t>> m_sizes;
    QDoubleSpinBox* m_mm3;
    QLabel* m_result;
    PreviewRow* m_preview;
    QPushButton* m_apply;
};

} // namespace ui
