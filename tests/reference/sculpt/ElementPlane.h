// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "tests/reference/fields/DenseFields.h"
#include "tests/reference/sculpt/ProtectedVoxels.h"
#include "tests/reference/sculpt/Rays.h"

#include <map>
#include <optional>
#include <utility>

namespace reference {

/// What the tools that press a mask into the volume share (core/sculpt/CutFrame.h). Codes and
/// fields are borrowed.
class ElementPlane {
public:
    using Place = std::pair<std::int64_t, std::int64_t>; ///< of an element
    /// Rules 4 and 5 for one element.
    struct Hit {
        std::int64_t zSurface = 0;
        std::int64_t zExit = 0; ///< restoring: zOuter
    };
    struct Column {
        std::int64_t zFrom = 0;
        std::int64_t zTo = 0;
        std::int64_t weight = 255;
    };
    static constexpr std::int64_t never = 0x7FFFFFFF;

    /// @param radiation as it is now
    ElementPlane(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
        DenseFields& fields, std::uint8_t layer, core::CutFrame frame);

    [[nodiscard]] const core::CutFrame& frame() const { return m_frame; }
    [[nodiscard]] std::optional<Hit> cast(std::int64_t a, std::int64_t b);
    /// Rule 7.
    [[nodiscard]] Column restoring(const Hit& hit, std::int64_t from, std::int64_t weight) const;
    /// How deep all elements that were cast looked; none were: nothing.
    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_searchedTo; }
    /// Rule 6.
    void lay(const std::map<Place, Column>& columns, core::Laying laying);

private:
    [[nodiscard]] std::optional<Hit> hitOf(std::int64_t a, std::int64_t b);

    std::optional<std::int32_t> m_searchedTo;
    const DenseArray<std::uint16_t>& m_codes;
    DenseArray<std::uint8_t> m_radiation; ///< as it was when the edit began
    DenseArray<std::uint8_t>& m_coverage;
    ProtectedVoxels m_protected;
    core::CutFrame m_frame;
};

/// What is left of coverage where a cut is refilled: rule 6.
[[nodiscard]] std::uint8_t refilled(std::uint8_t coverage, std::uint8_t cut);
/// Rounds down.
[[nodiscard]] std::int64_t floorDivide(std::int64_t value, std::int64_t divisor);
/// ⌊√value⌋, by other means than core's.
[[nodiscard]] std::int64_t squareRoot(std::int64_t value);

} // namespace reference
