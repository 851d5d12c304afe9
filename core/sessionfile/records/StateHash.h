// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <QByteArray>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace core {

/// The hash of everything that edits can change: SHA-256 over a tree of bricks, updated
/// incrementally. core/session/README.md defines it, with test vectors; a change requires a new
/// schema version of the session file.
///
/// Cost of update(): the changed bricks (about 250 MB/s) and at most six small nodes for each.
class StateHash {
public:
    /// Sets the present content of bricks; a brick without bytes or with only empty voxels is
    /// absent.
    void update(const std::vector<BrickImage>& bricks);
    /// The same with the `after` of changes.
    void update(const std::vector<BrickChange>& changes);

    /// @param documentJson Document::hashedState() as compact JSON
    /// @return 64 hex digits
    [[nodiscard]] QByteArray root(const QByteArray& documentJson) const;

private:
    using Digest = std::array<std::uint8_t, 32>;
    static constexpr int levels = 6; ///< above the leaves; each node has up to 16 children
    /// field · 2³² + plane · 2²⁴ + brick for leaves, shifted right by four bits per level
    using NodeKey = std::uint64_t;

    void setLeaf(
        const BrickKey& key, const std::vector<std::uint8_t>& bytes, std::vector<NodeKey>& touched);
    void updateAbove(std::vector<NodeKey> touched);

    std::array<std::map<NodeKey, Digest>, levels + 1> m_nodes;
};

} // namespace core
