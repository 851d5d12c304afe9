// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskPeel.h"
#include "core/sculpt/MaskScissors.h"
#include "tests/reference/MaskPlane.h"

namespace reference {

/// One open peel (core/sculpt/MaskPeel.h). Codes and fields are borrowed.
class Peel {
public:
    /// @param radiation as it is now
    Peel(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
        DenseFields& fields, core::MaskPeel peel);

    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_plane.searchedTo(); }
    void setDepth(std::int64_t depth);

private:
    core::MaskPeel m_peel;
    DenseArray<std::uint8_t>& m_coverage;
    DenseArray<std::uint8_t> m_before;
    MaskPlane m_plane;
    std::map<MaskPlane::Place, MaskPlane::Hit> m_sheet;
};

/// core/sculpt/MaskScissors.h.
std::optional<std::int32_t> cutWithScissors(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> radiation, DenseFields& fields, const core::MaskScissors& scissors);

} // namespace reference
