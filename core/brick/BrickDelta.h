// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <QByteArray>

#include <cstddef>
#include <vector>

namespace core {

/// What an edit changed, small enough to keep: the XOR of before and after of every brick, bytes of
/// four-byte words put together by significance, compressed with zstd.
///
/// The stream inside is "BDL1", then for each brick, in the order of keys: field, plane, 0, 0 (one
/// byte each), brick number (4 bytes little-endian), the brick's XOR (4096 or 16384 bytes).
/// XOR knows no direction: it leads from before to after and from after to before.
struct BrickDelta {
    static constexpr std::size_t maxPieceBytes = std::size_t(4) << 20;

    std::vector<QByteArray> pieces; ///< of the compressed stream; none: nothing changed

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] bool empty() const { return pieces.empty(); }
};

/// Compresses; about 300 MB/s on one core. Any thread.
[[nodiscard]] BrickDelta makeDelta(const std::vector<BrickChange>& changes);

/// The XOR images again, every one with its bytes. Any thread.
/// Errors: SessionDamaged with the reason as first argument, to which the caller adds the file.
[[nodiscard]] Result<std::vector<BrickImage>> expandDelta(const BrickDelta& delta);

/// @p image with @p difference laid over it; no bytes if every voxel is empty then.
/// @pre both are of the same brick; the difference has its bytes
[[nodiscard]] BrickImage exclusiveOr(const BrickImage& image, const BrickImage& difference);

} // namespace core
