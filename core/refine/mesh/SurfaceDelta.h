// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/refine/mesh/SimplexMeshDelta.h"

#include <QByteArray>

namespace core {

// The changes of a mesh as bytes for a session file, little-endian and not compressed:
//   "MDL1", u32 number of changed vertices, u32 number of changed faces;
//   for each vertex: u32 id, u8 sides (1: existed, 2: exists), then for each side 49 bytes: three
//     doubles, three neighbours and three faces (u32), u8 mark; if there are two sides, the second
//     is XORed with the first;
//   for each face: u32 id, u32 number of vertices before, u32 after, then both rings (u32 each).
// Both lists ascend by id. A difference has exactly one form. A listed vertex or face may be
// unchanged: earlier versions recorded a surface in this way that was laid again where it had been.

/// Ids must be below this to be packed. It limits the size of a mesh when bytes from a stranger are
/// applied.
constexpr std::uint32_t mostPackedIds = 1U << 24;

/// @pre ids are below mostPackedIds
[[nodiscard]] QByteArray packed(const SimplexMeshDelta& delta);

/// Unpacks them, exact bit by bit. Whatever the bytes are, it needs at most a few times their size
/// in memory; packed() of the result gives the same bytes. Errors: SessionDamaged (argument 1:
/// why).
[[nodiscard]] Result<SimplexMeshDelta> unpackedSurfaceDelta(const QByteArray& bytes);

/// Whether a mesh has the state before a change in all parts that changed; for changes that come
/// from a file. checkSimplexMesh() tells whether the mesh is sound afterwards.
[[nodiscard]] bool canRedo(const SimplexMeshDelta& delta, const SimplexMesh& mesh);
/// The same for the state after it.
[[nodiscard]] bool canUndo(const SimplexMeshDelta& delta, const SimplexMesh& mesh);

/// A whole mesh as a change of an empty one.
[[nodiscard]] SimplexMeshDelta deltaFromNothing(const SimplexMesh& mesh);

/// Lower-case hex, over everything in a mesh, little-endian: u32 number of vertices, u32 number of
/// faces, then by ascending id each vertex (u32 id and the 49 bytes as above) and each face (u32
/// id, u32 number of vertices, its ring).
[[nodiscard]] QByteArray sha256Of(const SimplexMesh& mesh);

} // namespace core
