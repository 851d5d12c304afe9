// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/morphology/BetweenSlices.h"
#include "ui/dialogs/segment/LabelLookDialog.h"

#include <array>
#include <cstdint>
#include <optional>

class QComboBox;
class QLabel;

namespace ui {

class FittingLabel;
class SegmentWorkRow;

/// Shows which slices of a segment count as drawn and how much lies between them, and fills it. It
/// follows the segment, so that one draws another slice where the result is not good enough.
class BetweenSlicesDialog : public LabelLookDialog {
    Q_OBJECT

public:
    explicit BetweenSlicesDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    void ask(int label);

private:
    struct Found {
        std::array<core::DrawnSlices, 3> drawn;
        std::optional<core::SliceAxis> axis{}; ///< none: no slice between drawn ones is empty
        std::int64_t voxels = 0; ///< that would be given
    };
    void count(const LabelFetch::Planes& planes) override;
    void forgetFound() override;
    void showState() override;
    void showFound();
    void carryOut();
    [[nodiscard]] std::optional<core::SliceAxis> chosenAxis() const; ///< none: found by itself
    [[nodiscard]] QString drawnText(const core::DrawnSlices& drawn) const;

    std::optional<Found> m_found; ///< none: it is being looked for, or could not be
    LabelFetch::Planes m_planes; ///< null: they are being read, or nobody looks at it
    QComboBox* m_axis;
    FittingLabel* m_drawn;
    QLabel* m_result;
    SegmentWorkRow* m_work;
};

} // namespace ui
