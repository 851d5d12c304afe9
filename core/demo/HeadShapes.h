// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

/// The shapes of the head as signed distances. Head space is in millimetres: x to the left, y to
/// posterior, z to superior, origin in the middle of the scan (about the third ventricle).
namespace core::demo {

/// Inner surface of the skull without the spinal canal.
float cranialCavity(const glm::vec3& p);
/// Foramen magnum and the spinal canal below it.
float spinalCanal(const glm::vec3& p);
/// Thickness of the skull at @p p.
float skullThickness(const glm::vec3& p);

/// The bones of the upper face as a solid, before cavities are taken out.
float facialMass(const glm::vec3& p);
/// The mastoid processes, solid.
float mastoid(const glm::vec3& p);

/// Outer surface of the body: cranium, face, ears, neck.
/// @param vault signed distance of the outer surface of the skull's vault
float bodySurface(const glm::vec3& p, float vault);

struct FaceDistances {
    float orbit = 0.0F; ///< the bony cavity, open to the front
    float globe = 0.0F; ///< eyeball
    float sinus = 0.0F; ///< frontal, maxillary, sphenoid, ethmoid and mastoid cells
    float nasal = 0.0F; ///< nasal cavity and throat
    float earCanal = 0.0F; ///< outer ear canal
};
FaceDistances faceCavities(const glm::vec3& p);

struct BoneDistances {
    float skull = 0.0F; ///< vault, base and upper face, cavities taken out
    float mandible = 0.0F;
    float vertebrae = 0.0F;
    float teeth = 0.0F;
};
/// @param cavity cranialCavity(p), @param thickness skullThickness(p), @param face faceCavities(p)
BoneDistances bones(const glm::vec3& p, float cavity, float thickness, const FaceDistances& face);

/// 1 in the middle of a suture of the vault, 0 away from it.
float suture(const glm::vec3& p);

} // namespace core::demo
