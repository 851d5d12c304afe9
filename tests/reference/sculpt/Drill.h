// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/DrillCut.h"
#include "tests/reference/fields/DenseFields.h"
#include "tests/reference/sculpt/ElementPlane.h"

#include <map>
#include <optional>
#include <utility>

namespace reference {

/// One open drill stroke (core/sculpt/DrillCut.h). Codes and fields are borrowed.
class Drill {
public:
    /// @param radiation as it is now
    Drill(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
        DenseFields& fields, core::DrillCut cut);

    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_plane.searchedTo(); }
    void extend(const std::vector<core::DrillSample>& samples);

private:
    struct Element {
        std::int64_t depth = 0;
        std::int64_t sum = 0; ///< mode Rate
        std::optional<ElementPlane::Hit> hit;
    };

    [[nodiscard]] std::int64_t weightUnder(
        const core::DrillSample& sample, std::int64_t a, std::int64_t b) const;

    core::DrillCut m_cut;
    ElementPlane m_plane;
    std::map<ElementPlane::Place, Element> m_elements;
};

} // namespace reference
