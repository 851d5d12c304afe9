// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkPieces.h"

#include "core/chunks/BoxWalk.h"

#include <algorithm>

namespace core {

namespace {

constexpr int cell = 4;
constexpr int alike = ChunkField::deviation * 3 / 2;

/// Gives the piece of a voxel to all that hang together with it.
void flood(const ChunkSource& source, const ChunkField& field, const BoxWalk& box,
    std::size_t start, ChunkPieces& pieces)
{
    const auto number = std::uint32_t(pieces.pieces.size());
    const glm::ivec3 home = box.placeOf(start) / cell;
    PieceJoining::Piece piece;
    std::vector<std::size_t> reached{start};
    pieces.ofVoxel[start] = number;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const std::size_t voxel = reached[i];
        ++piece.voxels;
        piece.codes += source.codes[voxel];
        piece.likelihoods += field.likelihood(voxel);
        box.forEachNeighbour(voxel, [&](std::size_t neighbour) {
            if (pieces.ofVoxel[neighbour] != ChunkPieces::none
                || source.owners[neighbour] != source.owners[voxel]
                || box.placeOf(neighbour) / cell != home || field.step(voxel, neighbour) > alike)
                return;
            pieces.ofVoxel[neighbour] = number;
            reached.push_back(neighbour);
        });
    }
    pieces.pieces.push_back(piece);
    pieces.owners.push_back(source.owners[start]);
}

std::vector<PieceJoining::Contact> contactsOf(
    const ChunkSource& source, const BoxWalk& box, const ChunkPieces& pieces)
{
    std::vector<std::uint64_t> faces;
    box.forEachPair([&](std::size_t voxel, std::size_t neighbour) {
        const std::uint32_t one = pieces.ofVoxel[voxel];
        const std::uint32_t other = pieces.ofVoxel[neighbour];
        if (one != other && source.owners[voxel] == source.owners[neighbour]
            && one != ChunkPieces::none)
            faces.push_back(
                PieceJoining::Contact{.first = std::min(one, other), .second = std::max(one, other)}
                    .pair());
    });
    std::sort(faces.begin(), faces.end());
    std::vector<PieceJoining::Contact> contacts;
    for (const std::uint64_t pair : faces) {
        if (!contacts.empty() && contacts.back().pair() == pair)
            ++contacts.back().faces;
        else
            contacts.push_back({std::uint32_t(pair >> 32U), std::uint32_t(pair)});
    }
    return contacts;
}

} // namespace

Result<ChunkPieces> chunkPieces(
    const ChunkSource& source, const ChunkField& field, const Progress& progress)
{
    const BoxWalk box(source.size);
    ChunkPieces pieces;
    pieces.ofVoxel.assign(box.voxels(), ChunkPieces::none);
    const std::size_t slice = std::size_t(source.size.x) * std::size_t(source.size.y);
    for (std::size_t voxel = 0; voxel < box.voxels(); ++voxel) {
        if (voxel % slice == 0) {
            if (progress.cancelled())
                return failure(ErrorCode::Cancelled);
            progress.report(
                QStringLiteral("Cutting into small pieces"), int(voxel / slice), source.size.z);
        }
        if (pieces.ofVoxel[voxel] == ChunkPieces::none
            && source.owners[voxel] != ChunkSource::outside)
            flood(source, field, box, voxel, pieces);
    }
    pieces.contacts = contactsOf(source, box, pieces);
    return pieces;
}

} // namespace core
