// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourEvolution.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/session/operations/segments/CodeSlabs.h"
#include "core/session/operations/segments/WorkedOutOperation.h"
#include "core/session/past/LabelReading.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Carries out an EvolveContour. It reads the labels of the plane, then, slab by slab, the codes
/// around the segment as far as the contour can come. The side thread computes the generations, and
/// the engine writes what they changed, as one row.
class ContourOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit ContourOperation(const EvolveContour& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;

private:
    /// Used by one thread at a time.
    struct Work {
        ContourGround ground;
        std::vector<std::vector<std::uint16_t>> slabs; ///< codes of the ground, slab by slab
    };
    void readLabels(SessionState& state);
    void findGround(SessionState& state);
    void readCodes(SessionState& state);
    void evolve(SessionState& state);
    [[nodiscard]] static Result<RelabelListed> evolved(
        const EvolveContour& edit, const Document& document, Work& work, Watch& watch);

    [[nodiscard]] const EvolveContour& contour() const { return edit().get<EvolveContour>(); }

    std::shared_ptr<Work> m_work;
    std::optional<LabelReading> m_reading; ///< until all labels are read
    std::optional<Ticket> m_asked; ///< question for codes that is not answered yet
    CodeSlabs m_slabs; ///< whose codes are not read yet
};

} // namespace core
