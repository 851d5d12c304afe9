// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// The values of a brick's voxels. All copies share them, so passing a brick on costs nothing and
/// reads no voxel. Code that reads or writes voxels does so through read() or write(), which record
/// it on threads that must not (ThreadWithoutVoxels.h). Copies may be used on several threads.
class BrickBytes {
public:
    /// No bytes at all; this means that every voxel is empty.
    BrickBytes() = default;
    BrickBytes(std::vector<std::uint8_t> bytes);

    [[nodiscard]] bool empty() const { return !m_bytes; }
    [[nodiscard]] std::size_t size() const { return m_bytes ? m_bytes->size() : 0; }
    void clear() { m_bytes.reset(); }

    [[nodiscard]] const std::vector<std::uint8_t>& read() const;
    /// Bytes that belong to this copy alone; they are copied first if others share them.
    [[nodiscard]] std::vector<std::uint8_t>& write();

    /// Compares the bytes, unless both are copies of the same.
    friend bool operator==(const BrickBytes& one, const BrickBytes& other);

private:
    std::shared_ptr<std::vector<std::uint8_t>> m_bytes; ///< null: none
};

} // namespace core
