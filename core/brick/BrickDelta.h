// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <QByteArray>

#include <cstddef>
#include <vector>

namespace core {

/// What an edit changed, small enough to keep: the XOR of before and after of every brick (which
/// voxels differ, then those by significance of their bytes), compressed with zstd.
///
/// The stream inside is described in core/session/README.md; generations of seed words stand in it
/// as distances from what their neighbours foretell (SeedWordForecast.h).
/// XOR knows no direction: it leads from before to after and from after to before.
struct BrickDelta {
    static constexpr std::size_t maxPieceBytes = std::size_t(4) << 20;

    std::vector<QByteArray> pieces; ///< of the compressed stream; none: nothing changed

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] bool empty() const { return pieces.empty(); }
};

/// Compresses; the liver of an adult, grown, in half a second. Any thread.
[[nodiscard]] BrickDelta makeDelta(const std::vector<BrickChange>& changes);

/// The XOR images again, every one with its bytes. Any thread.
/// Errors: SessionDamaged with the reason as first argument, to which the caller adds the file.
[[nodiscard]] Result<std::vector<BrickImage>> expandDelta(const BrickDelta& delta);

/// @p image with @p difference laid over it; no bytes if every voxel is empty then.
/// @pre both are of the same brick; the difference has its bytes
[[nodiscard]] BrickImage exclusiveOr(const BrickImage& image, const BrickImage& difference);

} // namespace core
