// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/refine/mesh/SimplexMeshDelta.h"

#include <QByteArray>

namespace core {

// What changed in a mesh as bytes, for a session file, little-endian and not compressed:
//   "MDL1", u32 changes of vertices, u32 changes of faces;
//   each vertex: u32 id, u8 sides (1: was there, 2: is there), then of each side 49 bytes: three
//     doubles, three neighbours and three faces (u32), u8 mark; of two sides the second is XORed
//     with the first;
//   each face: u32 id, u32 vertices before, u32 after, then both rings (u32 each).
// Both lists ascend by id. There is one form of a difference only.

/// Ids that can be packed lie below this: it bounds what a mesh takes when bytes of strangers are
/// applied to it.
constexpr std::uint32_t mostPackedIds = 1U << 24;

/// @pre ids are below mostPackedIds
[[nodiscard]] QByteArray packed(const SimplexMeshDelta& delta);

/// The way back, exact to the bit. Whatever the bytes are, it takes no more memory than a few times
/// theirs; packed() of what it gives are these bytes. Errors: SessionDamaged (argument 1: why).
[[nodiscard]] Result<SimplexMeshDelta> unpackedSurfaceDelta(const QByteArray& bytes);

/// Whether a mesh is what it was before a change, in all that changed: for changes that come from a
/// file. Whether the mesh is sound afterwards, checkSimplexMesh() says.
[[nodiscard]] bool canRedo(const SimplexMeshDelta& delta, const SimplexMesh& mesh);
/// The same for the way back.
[[nodiscard]] bool canUndo(const SimplexMeshDelta& delta, const SimplexMesh& mesh);

/// A whole mesh as what has to change in an empty one.
[[nodiscard]] SimplexMeshDelta deltaFromNothing(const SimplexMesh& mesh);

/// Lower-case hex, of all that there is in a mesh, little-endian: u32 vertices and u32 faces, then
/// by ascending id each vertex (u32 id and the 49 bytes as above) and each face (u32 id, u32
/// vertices, its ring).
[[nodiscard]] QByteArray sha256Of(const SimplexMesh& mesh);

} // namespace core
