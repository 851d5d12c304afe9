// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/reference/DenseFields.h"
#include "tests/reference/Rays.h"

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

    void extend(const std::vector<core::DrillSample>& samples);

private:
    /// Rules 4 and 5 for one element.
    struct Hit {
        std::int64_t zSurface = 0;
        std::int64_t zExit = 0;
    };
    struct Element {
        std::int64_t depth = 0;
        std::optional<Hit> hit;
    };

    [[nodiscard]] std::int64_t depthUnder(
        const core::DrillSample& sample, std::int64_t a, std::int64_t b) const;
    [[nodiscard]] std::optional<Hit> cast(std::int64_t a, std::int64_t b) const;
    void cutVoxels();

    const DenseArray<std::uint16_t>& m_codes;
    DenseArray<std::uint8_t> m_radiation; ///< as it was when the stroke began
    DenseArray<std::uint8_t>& m_coverage;
    core::DrillFrame m_frame;
    std::map<std::pair<std::int64_t, std::int64_t>, Element> m_elements;
};

} // namespace reference
