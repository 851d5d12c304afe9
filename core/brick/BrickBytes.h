// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// The values of a brick's voxels, shared by all copies: handing a brick on costs nothing, and
/// looks at no voxel. Who looks at them says so with read() or write(), which note it where the
/// thread is one that must not (ThreadWithoutVoxels.h). Copies may be used on several threads.
class BrickBytes {
public:
    /// No bytes at all, which means that every voxel is empty.
    BrickBytes() = default;
    BrickBytes(std::vector<std::uint8_t> bytes);

    [[nodiscard]] bool empty() const { return !m_bytes; }
    [[nodiscard]] std::size_t size() const { return m_bytes ? m_bytes->size() : 0; }
    void clear() { m_bytes.reset(); }

    [[nodiscard]] const std::vector<std::uint8_t>& read() const;
    /// Bytes of this copy's own. Cost: those of a brick, where another copy shares them.
    [[nodiscard]] std::vector<std::uint8_t>& write();

    /// Looks at the bytes, unless both are copies of one.
    friend bool operator==(const BrickBytes& one, const BrickBytes& other);

private:
    std::shared_ptr<std::vector<std::uint8_t>> m_bytes; ///< null: none
};

} // namespace core
