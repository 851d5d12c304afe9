// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/splitting/SplitParts.h"
#include "core/history/History.h"
#include "ui/tasks/LabelFetch.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace core {
struct SplitByCurve;
struct SplitSegment;
} // namespace core

namespace ui {

class Workspace;

/// Computes how many voxels both parts of a segment would have before it is split. The engine reads
/// the segment's labels once, as long as the history stays where it is, and a background thread
/// counts; if it is asked faster than that, only the latest question is answered. While an edit is
/// open nothing is read. GUI thread; no call waits or reads voxels.
class SplitTrial : public QObject {
    Q_OBJECT

public:
    struct Parts {
        std::int64_t staying = 0; ///< voxels that stay with the segment
        std::int64_t beyond = 0; ///< voxels of the new segment; 0, too, if nothing is split
        bool isInside = true; ///< as in core::SplitSides
    };

    explicit SplitTrial(Workspace& workspace, QObject* parent = nullptr);

    /// Asks for the parts that an edit would make. The last ones are kept until the new ones are
    /// known, unless they are of another segment. The edit's editable range is ignored, so the edit
    /// may give fewer voxels to the new segment.
    void look(const core::SplitByCurve& edit);
    void look(const core::SplitSegment& edit);
    /// Forgets the parts and everything that was read.
    void drop();

    /// The latest parts that are known; none before the first.
    [[nodiscard]] const std::optional<Parts>& parts() const { return m_parts; }
    /// Whether an answer is on its way.
    [[nodiscard]] bool isLooking() const { return bool(m_wanted) || m_counting.busy(); }
    /// "Liver: 1 043 mL · Liver 1: 482.1 mL": the parts in words, or that all lies on one side;
    /// empty before they are known.
    /// @param name of the segment; @param newName of the part that is split off
    [[nodiscard]] QString text(const QString& name, const QString& newName) const;

Q_SIGNALS:
    void changed(); ///< parts(), or isLooking()

private:
    using Count = std::function<core::Result<core::SplitSides>(
        const core::Document&, const core::VoxelRuns&, const core::Progress&)>;
    template <class E> void lookAt(const E& edit);
    void goOn();
    void read();
    void takeLabels(const LabelFetch::Planes& planes);
    void count();

    Workspace& m_workspace;
    int m_segment = 0; ///< label
    Count m_wanted; ///< empty: no question waits
    std::shared_ptr<const core::VoxelRuns>
        m_voxels; ///< of the segment at m_position; null: unknown
    core::RowId m_position{}; ///< of the history
    std::optional<Parts> m_parts;
    LabelFetch m_fetch;
    core::Background m_sorting; ///< last, as m_counting: their results go to all of the above
    core::Background m_counting;
};

} // namespace ui
