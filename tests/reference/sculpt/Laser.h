// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/LaserCut.h"
#include "tests/reference/fields/DenseFields.h"
#include "tests/reference/sculpt/ElementPlane.h"
#include "tests/reference/sculpt/ProtectedVoxels.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace reference {

/// One open stroke of the laser (core/sculpt/LaserCut.h): at each step every voxel against every
/// beam. Codes and fields are borrowed.
class Laser {
public:
    /// @param radiation as it is now
    Laser(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
        DenseFields& fields, core::LaserCut cut);

    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_plane.searchedTo(); }
    void extend(const std::vector<core::DrillSample>& samples);

private:
    struct Vector {
        std::int64_t x = 0;
        std::int64_t y = 0;
        std::int64_t z = 0;
    };
    struct Beam {
        Vector foot;
        Vector across; ///< X, Y, N of rule 5
        Vector up;
        Vector normal;
        std::int64_t exit = ElementPlane::never;
    };

    [[nodiscard]] std::optional<Beam> beamAt(std::int64_t a, std::int64_t b);
    [[nodiscard]] bool materialAt(const Index16& position) const;
    [[nodiscard]] std::int64_t weight(std::int64_t p, std::int64_t q) const;
    [[nodiscard]] std::int64_t depthOf(const ElementPlane::Place& place) const;
    void lay(const Beam& beam, std::int64_t depth);

    const DenseArray<std::uint16_t>& m_codes;
    DenseArray<std::uint8_t> m_radiation; ///< as it was when the edit began
    DenseArray<std::uint8_t>& m_coverage;
    ProtectedVoxels m_protected;
    core::LaserCut m_cut;
    ElementPlane m_plane;
    std::map<ElementPlane::Place, std::vector<std::int64_t>>
        m_depths; ///< of the samples in an element
    std::map<ElementPlane::Place, std::optional<Beam>> m_beams;
};

} // namespace reference
