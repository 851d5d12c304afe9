// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkField.h"
#include "core/chunks/PieceJoining.h"

namespace core {

/// A box cut into small pieces: within cells of 4³ voxels, the voxels of one owner that are
/// connected by steps of at most one and a half mean deviations.
struct ChunkPieces {
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    std::vector<std::uint32_t> ofVoxel; ///< none: left out
    std::vector<PieceJoining::Piece> pieces;
    std::vector<std::uint8_t> owners; ///< by piece
    /// Contacts between pieces of one owner, with the number of faces at which they touch;
    /// ascending.
    std::vector<PieceJoining::Contact> contacts;
};

/// Errors: Cancelled.
[[nodiscard]] Result<ChunkPieces> chunkPieces(
    const ChunkSource& source, const ChunkField& field, const Progress& progress);

} // namespace core
