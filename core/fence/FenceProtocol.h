// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

/// The messages between a program and its decoder processes, and how each side reads what the other
/// sent: fixed messages over a socket, and bytes in shared memory. Both ends are the same program,
/// so versions cannot differ. An image may have taken over a decoder, so the program trusts none of
/// its messages.
namespace core::fence {

/// The file descriptors of a decoder process.
constexpr int socketDescriptor = 3;
constexpr int memoryDescriptor = 4;

constexpr std::uint32_t magic = 0x464e4345;
constexpr std::size_t longestSentence = 240;
constexpr std::size_t longestParameters = 128;

/// The first message of a decoder.
struct Ready {
    std::uint32_t magic = fence::magic;
    std::uint32_t filtered = 0; ///< 1: the kernel blocks system calls that it does not need
};

/// A request. The input is at the beginning of the memory, the output after it at the beginning of
/// a page.
struct Request {
    std::uint32_t magic = fence::magic;
    std::uint32_t number = 0;
    std::uint64_t memoryBytes = 0; ///< present size of the memory
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

/// What came over the socket of a decoder.
enum class Heard {
    Message,
    Silence, ///< nothing in the time that it had
    End, ///< the decoder closed its end
    Noise, ///< something that is no such message
};

/// Waits for the first message of a decoder.
/// @param socket the program's end, of type SOCK_SEQPACKET
/// @param ready the message, if there is one; otherwise not to be used
[[nodiscard]] Heard hear(int socket, std::chrono::milliseconds patience, Ready& ready);

/// Waits for the reply to the request of that number. A reply that is a message has a known verdict
/// and a sentence that is not too long.
[[nodiscard]] Heard hear(
    int socket, std::chrono::milliseconds patience, std::uint32_t number, Reply& reply);

/// Why a request was refused: one line of printable letters, never empty. For a reply that was
/// heard.
[[nodiscard]] Clause sentenceOf(const Reply& reply);

/// Whether everything that a request names lies in its memory, and the input before the output.
[[nodiscard]] bool isSound(const Request& request);

} // namespace core::fence
