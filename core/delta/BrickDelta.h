// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <QByteArray>

#include <array>
#include <cstddef>
#include <vector>

namespace core {

/// What an edit changed, in a form small enough to keep: the XOR of before and after for every
/// changed brick, compressed with zstd. It stores which voxels differ and then their differences;
/// of a growth it stores only what does not follow from where the growth began
/// (SeedWordPrediction.h). core/session/README.md describes the stream.
///
/// XOR has no direction: the same delta leads from before to after and from after to before.
struct BrickDelta {
    static constexpr std::size_t maxPieceBytes = std::size_t(4) << 20;

    std::vector<QByteArray> pieces; ///< of the compressed stream; none: nothing changed

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] bool empty() const { return pieces.empty(); }
};

/// Compresses changes. The grown liver of an adult takes a third of a second. Any thread.
/// @param changes no key twice
/// @param grid of the volume, which tells which bricks are neighbours
[[nodiscard]] BrickDelta makeDelta(const std::vector<BrickChange>& changes, const BrickGrid& grid);

/// The packed form of a row that changed only the surface and no voxel begins with this
/// (session/surface/SurfaceStep.h).
constexpr std::array<char, 4> surfaceStepMagic{'S', 'R', 'F', '1'};

/// Restores the XOR images, each with its bytes, in the order of the changes. Any thread. The input
/// may come from a stranger: no memory is reserved for bricks that the volume does not have.
/// Errors: SessionDamaged with the reason as first argument; the caller adds the file.
[[nodiscard]] Result<std::vector<BrickImage>> expandDelta(
    const BrickDelta& delta, const BrickGrid& grid);

/// @p image combined with @p difference by XOR; without bytes if every voxel is empty then.
/// @pre both are of the same brick, and the difference has its bytes
[[nodiscard]] BrickImage exclusiveOr(const BrickImage& image, const BrickImage& difference);

} // namespace core
