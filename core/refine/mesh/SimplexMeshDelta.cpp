// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexMeshDelta.h"

namespace core {

void SimplexMeshDelta::redo(SimplexMesh& mesh) const
{
    for (const VertexChange& change : vertices)
        mesh.putVertex(change.id, change.after);
    for (const FaceChange& change : faces)
        mesh.putFace(change.id, change.after);
}

void SimplexMeshDelta::undo(SimplexMesh& mesh) const
{
    for (const VertexChange& change : vertices)
        mesh.putVertex(change.id, change.before);
    for (const FaceChange& change : faces)
        mesh.putFace(change.id, change.before);
}

} // namespace core
