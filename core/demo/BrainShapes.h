// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace core::demo {

/// The tissues of the brain model.
enum class BrainTissue : std::uint8_t {
    Fluid, ///< cerebrospinal fluid outside the ventricles
    Ventricle,
    Grey,
    White,
    Nucleus, ///< deep grey
    Cerebellum,
    BrainStem,
    Membrane, ///< falx and tentorium
    Calcification,
};

/// The tissue at one point inside the skull or the spinal canal.
struct BrainSample {
    float value = 8.0F; ///< HU
    BrainTissue tissue = BrainTissue::Fluid;
};

/// @param p head space (core/demo/HeadShapes.h)
/// @param cavity signed distance of cranialCavity() joined with spinalCanal(), negative at @p p
BrainSample brainAt(const glm::vec3& p, float cavity);

} // namespace core::demo
