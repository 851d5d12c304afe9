// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/history/History.h"
#include "core/morphology/BetweenSlices.h"
#include "ui/tasks/LabelFetch.h"

#include <QDialog>
#include <QTimer>

#include <array>
#include <cstdint>
#include <optional>

class QComboBox;
class QLabel;

namespace ui {

class FittingLabel;
class SegmentWorkRow;
class Workspace;

/// Shows which slices of a segment count as drawn and how much lies between them, and fills it. It
/// stays open beside the window and follows the segment, so that one draws another slice where the
/// result is not good enough. The labels are read by the engine and looked through on another
/// thread.
class BetweenSlicesDialog : public QDialog {
    Q_OBJECT

public:
    explicit BetweenSlicesDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    void ask(int label);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    struct Found {
        std::array<core::DrawnSlices, 3> drawn;
        std::optional<core::SliceAxis> axis{}; ///< none: no slice between drawn ones is empty
        std::int64_t voxels = 0; ///< that would be given
    };
    void look();
    void count(const LabelFetch::Planes& planes);
    void forget();
    void showState();
    void showFound();
    void carryOut();
    [[nodiscard]] std::optional<core::SliceAxis> chosenAxis() const; ///< none: found by itself
    [[nodiscard]] QString drawnText(const core::DrawnSlices& drawn) const;

    Workspace& m_workspace;
    int m_label = 0;
    std::optional<Found> m_found; ///< none: it is being looked for, or could not be
    LabelFetch::Planes m_planes; ///< null: they are being read, or nobody looks at it
    bool m_looking = false;
    std::optional<core::RowId> m_position; ///< of the history, at which it was looked
    FittingLabel* m_whose;
    QComboBox* m_axis;
    FittingLabel* m_drawn;
    QLabel* m_result;
    SegmentWorkRow* m_work;
    QTimer m_lookSoon; ///< after several changes once
    LabelFetch m_fetch;
    core::Background m_counting; ///< last: its results are delivered to all of the above
};

} // namespace ui
