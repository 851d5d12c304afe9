// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/morphology/BetweenSlices.h"
#include "ui/dialogs/segment/LabelLookDialog.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;

namespace ui {

class FittingLabel;
class PreviewRow;
class SegmentWorkRow;

/// Fills the empty slices between the drawn slices of a segment by interpolation, or what lies
/// between the planes if it was drawn on planes of several directions. Before that it shows which
/// slices or planes count as drawn and how many voxels would be filled, and all views preview them.
/// It looks again whenever the segment changes, so the user can draw one more slice where the
/// result would not be good enough.
class BetweenSlicesDialog : public LabelLookDialog {
    Q_OBJECT

public:
    explicit BetweenSlicesDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Opens the dialog for a segment.
    void ask(int label);

private:
    struct Found {
        std::array<core::DrawnSlices, 3> drawn;
        std::optional<core::SliceAxis> axis{}; ///< none: between the drawn slices none is empty
        /// Those on which it was drawn, in several directions; none: the axis counts.
        std::optional<std::vector<core::DrawnPlane>> planes{};
        std::int64_t voxels = 0; ///< how many voxels would be filled
    };
    void count(const LabelFetch::Planes& planes) override;
    void forgetFound() override;
    void showState() override;
    void showFound();
    void follow(); ///< updates the preview to what was found
    void carryOut();
    [[nodiscard]] core::FillBetweenSlices chosen() const;
    /// None: the axis is found automatically.
    [[nodiscard]] std::optional<core::SliceAxis> chosenAxis() const;
    /// The planes in several directions on which it was drawn; empty: there are none, or an axis
    /// was chosen.
    [[nodiscard]] std::vector<core::DrawnPlane> planesOfStrokes() const;
    [[nodiscard]] QString drawnText(const core::DrawnSlices& drawn) const;
    [[nodiscard]] QString drawnText(const std::vector<core::DrawnPlane>& planes) const;

    std::optional<Found> m_found; ///< none: not known yet, or it could not be found out
    LabelFetch::Planes m_planes; ///< the labels that were read; null: not read
    QComboBox* m_axis;
    FittingLabel* m_drawn;
    QLabel* m_result;
    PreviewRow* m_preview;
    SegmentWorkRow* m_work;
};

} // namespace ui
