// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/session/operations/segments/CodeSlabs.h"
#include "core/session/operations/segments/WorkedOutOperation.h"
#include "core/session/past/LabelReading.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Carries out a SplitIslands. It reads the labels of the segment's plane and, with an editable
/// range, those of the planes that the range refers to and the values around the segment; an engine
/// that writes evaluates the range again. The side thread finds the islands, and lists in the edit
/// the segments that they become. As a preview it writes their labels, and they are segments of the
/// document once it is committed.
class SplitIslandsOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    SplitIslandsOperation(const SplitIslands& edit, Kind kind, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    /// As Operation::foresee(). Returns false for an edit that does not list its segments, because
    /// its islands must be counted first, and for a preview that stands open.
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    /// Used by one thread at a time.
    struct Work {
        std::vector<LabelReading> readings; ///< the segment's plane first
        VoxelBox box; ///< around the segment; empty: no values are read
        std::vector<std::uint16_t> codes; ///< of the box, slab by slab
    };
    [[nodiscard]] const SplitIslands& split() const { return edit().get<SplitIslands>(); }
    void readLabels(SessionState& state);
    void findBox(SessionState& state);
    void readCodes(SessionState& state);
    void workOut(SessionState& state);
    [[nodiscard]] static Result<LabelListed> listed(
        SplitIslands& edit, const Document& document, Work& work, const Progress& progress);

    std::shared_ptr<Work> m_work;
    std::size_t m_reading = 0; ///< which reader; their number: all labels are read
    CodeSlabs m_slabs; ///< whose codes are not read yet
    std::optional<Ticket> m_asked; ///< question that is not answered yet
};

} // namespace core
