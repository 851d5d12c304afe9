// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>

namespace core {

/// The program may not take so much more memory: what its own operator new throws
/// (app/Allocation.cpp).
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

/// Keeps some address space that nobody uses, so that there is memory to tell with, and to close
/// what is open, once there is none. Again when that is done.
void keepMemoryReserve() noexcept;
/// Gives it up: memory was refused. Any thread, also in a signal handler.
void giveUpMemoryReserve() noexcept;
/// Memory was refused since the program began, or since the reserve was kept again.
[[nodiscard]] bool memoryWasRefused() noexcept;
/// Whether a piece of memory of some size cannot be had right now. Also in a signal handler.
[[nodiscard]] bool isMemoryShort() noexcept;
/// How much of its address space the program has taken; 0: not known.
[[nodiscard]] std::size_t addressSpaceBytes() noexcept;

} // namespace core
