// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace test {

/// A CT that is made by a formula, with what each voxel belongs to: what a user is to segment, and
/// what that should come to.
class MadeScan {
public:
    /// The value of a voxel in HU and its part, by its place from the middle of the volume (mm).
    using Formula =
        std::function<std::pair<double, int>(const glm::ivec3& voxel, const glm::dvec3& mm)>;

    MadeScan(const glm::ivec3& size, const glm::dvec3& spacingMm, const Formula& formula);

    [[nodiscard]] const glm::ivec3& size() const { return m_size; }
    [[nodiscard]] glm::dvec3 placeLps(const glm::dvec3& voxel) const;
    /// Writes it as a DICOM series.
    void write(const QString& folder) const;
    /// A mask: 1 in the voxels whose part, or whose place in LPS mm, is asked for.
    [[nodiscard]] std::vector<std::uint8_t> mask(
        const std::function<bool(int part, const glm::dvec3& placeLps)>& isMeant) const;

private:
    [[nodiscard]] std::size_t indexOf(const glm::ivec3& voxel) const;

    glm::ivec3 m_size;
    glm::dvec3 m_spacing;
    std::vector<int> m_hounsfield; ///< x fastest
    std::vector<std::uint8_t> m_parts;
};

/// The demonstration head in voxels of 1.5 mm: a quarter as many, with the noise that such large
/// ones have. The parts are core::HeadPart.
[[nodiscard]] MadeScan coarseHead();

/// A liver as round as a ball, and what a network took for it: without a lobe, and through a thin
/// neck into something else that is as bright. 86 × 60 × 60 voxels of 3 mm. A part is a sum of
/// these two.
[[nodiscard]] MadeScan mistakenLiver();
inline constexpr int isLiver = 1;
inline constexpr int isTakenForLiver = 2;
inline constexpr glm::dvec3 inLiver(30, 30, 30); ///< voxels, like the next two
inline constexpr glm::dvec3 inLeak(66, 30, 30);
inline constexpr glm::dvec3 inLobe(12, 30, 30); ///< the one that is missing

/// A lung with a lesion (part 1) in its middle, of lesionMm × 16 × 16 mm; voxels of 1 mm.
[[nodiscard]] MadeScan lungWithLesion();
inline constexpr double lesionMm = 24.0;

} // namespace test
