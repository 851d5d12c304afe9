// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "tests/reenactment/MaskGrid.h"
#include "tests/reenactment/sighted/SeenPlane.h"

namespace reenact {

/// The eyes of somebody who knows the organ, at a program that shows one cutting plane after the
/// other. It alone knows the reference, and gives nothing away of it but how a plane reads.
///
/// A reader does not see the organ's border where grey values change most, but where it is: a
/// radiologist tells a liver from a stomach of the same grey. So a plane's reading is the
/// reference's own outline on that plane, which the reader gets wrong by 1 mm (root of the mean
/// square, each way on the plane), alike over some 8 mm. The error belongs to the plane: who looks
/// again reads the same, and learns no more from it. On another plane it is another one.
class Reader {
public:
    static constexpr double errorMm = 1.0;
    static constexpr double errorWidthMm = 8.0;

    Reader(const core::LoadedVolume& study, Mask reference, std::uint64_t seed);

    /// Opens a plane. @param seen the mask, or what the surface encloses, whose contour is drawn
    [[nodiscard]] SeenPlane look(const CuttingPlane& plane, const Mask& seen);
    /// How many planes have been opened.
    [[nodiscard]] int looks() const { return m_looks; }

private:
    const core::LoadedVolume& m_study;
    glm::dmat4 m_toIndex;
    Mask m_reference;
    std::uint64_t m_seed;
    int m_looks = 0;
};

} // namespace reenact
