// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/OutlineCut.h"
#include "core/sculpt/ShellPeel.h"
#include "tests/reference/sculpt/ElementPlane.h"

namespace reference {

/// One open peel (core/sculpt/ShellPeel.h). Codes and fields are borrowed.
class Peel {
public:
    /// @param radiation as it is now
    Peel(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
        DenseFields& fields, core::ShellPeel peel);

    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_plane.searchedTo(); }
    void setDepth(std::int64_t depth);

private:
    core::ShellPeel m_peel;
    DenseArray<std::uint8_t>& m_coverage;
    DenseArray<std::uint8_t> m_before;
    ElementPlane m_plane;
    std::map<ElementPlane::Place, ElementPlane::Hit> m_sheet;
};

/// core/sculpt/OutlineCut.h.
std::optional<std::int32_t> cutWithScissors(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> radiation, DenseFields& fields, const core::OutlineCut& scissors);

} // namespace reference
