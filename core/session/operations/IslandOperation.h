// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/kinds/Edit.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "core/session/operations/AbortableOperation.h"
#include "core/session/operations/Relabelling.h"
#include "core/session/past/LabelReader.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace core {

/// An edit of a segment as a whole that is worked out from all labels of its plane (CleanSegment,
/// ReshapeSegment, FillBetweenSlices, MirrorSegment, SplitIslands, SplitSegment): it reads them,
/// works out on the side thread which voxels are meant, and lets the engine write them; one row if
/// it changed anything.
class IslandOperation final : public AbortableOperation {
public:
    /// @param again as in VoxelOperation
    explicit IslandOperation(const CleanSegment& edit, RowId again = 0);
    explicit IslandOperation(const ReshapeSegment& edit, RowId again = 0);
    explicit IslandOperation(const FillBetweenSlices& edit, RowId again = 0);
    explicit IslandOperation(const MirrorSegment& edit, RowId again = 0);
    explicit IslandOperation(const SplitIslands& edit, RowId again = 0);
    explicit IslandOperation(const SplitSegment& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_relabelling.done(); }
    /// How many segments are made of islands is known when they have been counted.
    [[nodiscard]] bool foresee(Document& document) const override;

    void abort() override;
    [[nodiscard]] bool isAbortable() const override { return !m_isWriting && !done(); }
    [[nodiscard]] int percent() const override { return m_work->percent; }

private:
    /// What the side thread shares with the session's.
    struct Work {
        Work();
        std::atomic<int> percent = -1;
        Progress progress;
    };
    /// What is to be written; several segments may receive voxels, or one.
    using Listed = std::variant<RelabelListed, LabelListed>;
    /// @param edit may be completed by what is found
    using LabelWork = std::function<Result<Listed>(const Document& document,
        std::span<const std::uint8_t> labels, const Progress& progress, Edit& edit)>;

    IslandOperation(Edit edit, int segment, LabelWork workOut, RowId again);
    void readNext(SessionState& state);
    void write(SessionState& state, Result<Listed>&& listed);

    Edit m_edit;
    int m_segment; ///< label
    LabelWork m_workOut;
    std::shared_ptr<Work> m_work;
    std::optional<LabelReader> m_reader;
    std::optional<Ticket> m_asked; ///< for labels
    bool m_isWriting = false;
    Relabelling m_relabelling;
};

} // namespace core
