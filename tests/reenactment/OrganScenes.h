// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "tests/reenactment/MaskGrid.h"

#include <optional>

namespace reenact {

enum class Organ : std::uint8_t {
    None,
    Liver,
    Heart,
    Stomach,
    Spleen,
    Kidney,
    Lung,
    Hip,
    Femur,
    PortalVein
};

/// Organs in a volume of grey values that differ little, and whose they are.
struct OrganScene {
    core::LoadedVolume study;
    test::Bytes organs; ///< Organ

    [[nodiscard]] Mask maskOf(Organ organ) const;
};

/// A body by code: a liver of two lobes under a heart and on a stomach; a spleen beside a kidney; a
/// lung over a stomach full of gas. What one leaks into differs by some two thirds of the noise's
/// deviation; around them are muscle and fat, unevenly. Partial volume at every border.
/// @param scale of its lengths in voxels; at 1 a liver has some 110 000 voxels
[[nodiscard]] OrganScene organPhantom(Organ organ, double scale);

/// That organ and what lies beside it in ct_totalseg_body_3mm; none: no shared data, or it is not
/// in it (heart and, but for what lies on the liver, lung).
/// @param beside the neighbour that is to be in the scene; none: a liver's stomach, a spleen's
/// kidney
[[nodiscard]] std::optional<OrganScene> realOrgans(Organ organ, Organ beside = Organ::None);

} // namespace reenact
