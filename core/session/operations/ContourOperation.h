// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/contour/ContourEvolution.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/session/operations/AbortableOperation.h"
#include "core/session/operations/Relabelling.h"
#include "core/session/past/LabelReader.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// A contour that evolves (EvolveContour). It reads the labels of the plane, then the codes around
/// the segment as far as the contour can come, slab by slab; the side thread works out the
/// generations, and the engine writes what they changed, as one row.
class ContourOperation final : public AbortableOperation {
public:
    /// @param again as in VoxelOperation
    explicit ContourOperation(const EvolveContour& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_relabelling.done(); }

    void abort() override;
    [[nodiscard]] bool isAbortable() const override { return !m_isWriting && !done(); }
    [[nodiscard]] int percent() const override { return m_work->percent; }

private:
    /// What the side thread shares with the session's.
    struct Work {
        std::atomic<int> percent = -1;
        Progress progress;
        ContourGround ground; ///< of one thread at a time, as the next
        std::vector<std::vector<std::uint16_t>> slabs; ///< codes of the ground, one after the other
    };
    void readLabels(SessionState& state);
    void findGround(SessionState& state);
    void readCodes(SessionState& state);
    void evolve(SessionState& state);
    void write(SessionState& state, Result<RelabelListed>&& relabel);
    [[nodiscard]] static Result<RelabelListed> evolved(
        const EvolveContour& edit, const Document& document, Work& work);

    EvolveContour m_edit;
    std::shared_ptr<Work> m_work;
    std::optional<LabelReader> m_reader;
    std::optional<Ticket> m_asked; ///< for labels or codes
    int m_nextSlice = 0; ///< whose codes are asked for next
    bool m_isWriting = false;
    Relabelling m_relabelling;
};

} // namespace core
