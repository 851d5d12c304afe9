// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/demo/VesselTree.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace core {

/// The parts of the demonstration head; the values are those of its label file.
enum class HeadPart : std::uint8_t {
    Air = 0,
    Skin,
    Fat,
    Muscle,
    Skull,
    Mandible,
    Vertebrae,
    Teeth,
    Airway, ///< sinuses, nose, throat, ear canals
    Eye,
    GreyMatter,
    WhiteMatter,
    DeepNuclei,
    Cerebellum,
    BrainStem,
    Fluid, ///< outside the ventricles
    Ventricles,
    Membranes,
    Vessels,
};

struct HeadPartName {
    HeadPart part;
    const char* name;
};
/// All parts with their names in English, Air first.
std::span<const HeadPartName> headPartNames();

/// A head defined by formulas: density and part at every point, without scanner noise.
///
/// Edges are smooth over about a voxel of 1 mm (partial volume); the part of a point is the one
/// that fills most of its surroundings. Values are Hounsfield units of a contrast-enhanced CT. The
/// same on every call and thread.
class HeadPhantom {
public:
    struct Sample {
        float hounsfield = -1000.0F;
        HeadPart part = HeadPart::Air;
    };

    /// @param p millimetres from the middle of the head; x left, y posterior, z superior
    [[nodiscard]] Sample at(const glm::vec3& p) const;

private:
    demo::VesselTree m_vessels;
};

} // namespace core
