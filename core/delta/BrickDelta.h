// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <QByteArray>

#include <array>
#include <cstddef>
#include <vector>

namespace core {

/// What an edit changed, small enough to keep: the XOR of before and after of every brick (which
/// voxels differ, then these; of what grew only what does not follow from where it began),
/// compressed with zstd.
///
/// The stream inside is described in core/session/README.md; what is known of a growth in
/// SeedWordForecast.h.
/// XOR knows no direction: it leads from before to after and from after to before.
struct BrickDelta {
    static constexpr std::size_t maxPieceBytes = std::size_t(4) << 20;

    std::vector<QByteArray> pieces; ///< of the compressed stream; none: nothing changed

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] bool empty() const { return pieces.empty(); }
};

/// Compresses; the liver of an adult, grown, in a third of a second. Any thread.
/// @param changes no key twice @param grid of the volume, to know which bricks lie side by side
[[nodiscard]] BrickDelta makeDelta(const std::vector<BrickChange>& changes, const BrickGrid& grid);

/// What the packed form of a row begins with that changed no voxel but the surface
/// (session/surface/SurfaceStep.h).
constexpr std::array<char, 4> surfaceStepMagic{'S', 'R', 'F', '1'};

/// The XOR images again, every one with its bytes, in the order of the changes. Any thread. However
/// few bytes there are and whoever made them: no brick that the volume lacks is given room.
/// Errors: SessionDamaged with the reason as first argument, to which the caller adds the file.
[[nodiscard]] Result<std::vector<BrickImage>> expandDelta(
    const BrickDelta& delta, const BrickGrid& grid);

/// @p image with @p difference laid over it; no bytes if every voxel is empty then.
/// @pre both are of the same brick; the difference has its bytes
[[nodiscard]] BrickImage exclusiveOr(const BrickImage& image, const BrickImage& difference);

} // namespace core
