// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// What a program and its decoders say to each other: fixed messages over a socket, bytes in memory
/// that both see. Both ends are the same program, so that no versions meet.
namespace core::fence {

/// Where a decoder finds its ends.
constexpr int socketDescriptor = 3;
constexpr int memoryDescriptor = 4;

constexpr std::uint32_t magic = 0x464e4345;
constexpr std::size_t longestSentence = 240;
constexpr std::size_t longestParameters = 128;

/// The first message of a decoder.
struct Ready {
    std::uint32_t magic = fence::magic;
    std::uint32_t filtered = 0; ///< 1: the kernel stops system calls that it does not need
};

/// Input lies at the beginning of the memory, output behind it at a page's beginning.
struct Request {
    std::uint32_t magic = fence::magic;
    std::uint32_t number = 0;
    std::uint64_t memoryBytes = 0; ///< how large the memory is now
    std::uint64_t inputBytes = 0;
    std::uint64_t outputAt = 0;
    std::uint64_t outputBytes = 0;
    std::uint32_t parameterBytes = 0;
    std::array<std::uint8_t, longestParameters> parameters{};
};

enum class Verdict : std::uint32_t { Done = 1, Refused = 2 };

struct Reply {
    std::uint32_t magic = fence::magic;
    std::uint32_t number = 0; ///< of the request
    Verdict verdict = Verdict::Refused;
    std::uint32_t sentenceBytes = 0;
    std::array<char, longestSentence> sentence{}; ///< UTF-8: why it was refused
};

} // namespace core::fence
