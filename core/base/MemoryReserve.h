// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>

namespace core {

/// Thrown by the program's operator new when it may not take more memory (app/Allocation.cpp).
class MemoryRefused : public std::bad_alloc {
public:
    explicit MemoryRefused(std::size_t bytes)
        : m_bytes(bytes)
    {
    }
    [[nodiscard]] const char* what() const noexcept override { return "not enough memory"; }
    [[nodiscard]] std::size_t bytes() const noexcept { return m_bytes; }

private:
    std::size_t m_bytes;
};

/// Reserves some address space, so that errors can be reported and files closed when memory runs
/// out. To be called again when that is done.
void keepMemoryReserve() noexcept;
/// Releases it because memory was refused. Any thread, also in a signal handler.
void giveUpMemoryReserve() noexcept;
/// Whether memory was refused since the program began, or since keepMemoryReserve() was last
/// called.
[[nodiscard]] bool memoryWasRefused() noexcept;
/// Whether memory of a certain size is not available now. Also in a signal handler.
[[nodiscard]] bool isMemoryShort() noexcept;
/// How much address space the program has taken; 0: unknown.
[[nodiscard]] std::size_t addressSpaceBytes() noexcept;

} // namespace core
