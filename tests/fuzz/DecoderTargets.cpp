// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/fence/DecodeWorker.h"
#include "core/fence/FenceProtocol.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/socket.h>
#include <unistd.h>

namespace test {

using namespace core;

namespace {

using std::chrono::milliseconds;

/// What is heard lies there already, or never comes.
constexpr milliseconds atOnce{0};
constexpr std::uint32_t firstRequest = 1;

/// The socket between a program and a decoder, of which the decoder's end is closed once it has
/// said everything.
class DecoderSocket {
public:
    DecoderSocket()
    {
        if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, m_ends.data()) != 0)
            qFatal("no socket");
    }
    DecoderSocket(const DecoderSocket&) = delete;
    DecoderSocket& operator=(const DecoderSocket&) = delete;
    ~DecoderSocket()
    {
        close(m_ends[0]);
        hangUp();
    }

    [[nodiscard]] int programsEnd() const { return m_ends[0]; }
    /// @return false: no more goes into the socket
    bool say(FuzzBytes message)
    {
        return send(m_ends[1], message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
    }
    void hangUp()
    {
        if (m_ends[1] >= 0)
            close(m_ends[1]);
        m_ends[1] = -1;
    }

private:
    std::array<int, 2> m_ends{-1, -1};
};

/// Each message begins with its length, in two bytes.
void sayInMessages(DecoderSocket& socket, FuzzBytes bytes)
{
    constexpr std::size_t lengthBytes = 2;
    bool taken = true;
    while (taken && bytes.size() >= lengthBytes) {
        const std::size_t length = std::size_t(bytes[0]) | std::size_t(bytes[1]) << 8;
        bytes = bytes.subspan(lengthBytes);
        const FuzzBytes message = bytes.first(std::min(length, bytes.size()));
        bytes = bytes.subspan(message.size());
        taken = socket.say(message);
    }
}

void checkHeard(const fence::Reply& reply)
{
    if (reply.verdict == fence::Verdict::Done)
        return;
    if (reply.verdict != fence::Verdict::Refused)
        qFatal("a verdict that there is not");
    const QString sentence = fence::sentenceOf(reply);
    if (sentence.isEmpty() || sentence.size() > qsizetype(fence::longestSentence))
        qFatal("no sentence, or one that is too long");
    if (!std::all_of(sentence.begin(), sentence.end(), [](QChar letter) {
            return letter.isPrint() && letter.category() != QChar::Separator_Line
                && letter.category() != QChar::Separator_Paragraph;
        }))
        qFatal("a sentence that is not one printable line");
}

bool threw = false;

/// Reads and writes all that it may; refuses with its parameters as the sentence, and throws them
/// where they begin with '!'.
QString workOfAnyKind(std::span<const std::uint8_t> parameters, std::span<const std::uint8_t> input,
    std::span<std::uint8_t> output)
{
    std::fill(output.begin(), output.end(),
        std::uint8_t(std::accumulate(input.begin(), input.end(), 0U)));
    const std::string said(parameters.begin(), parameters.end());
    threw = said.starts_with('!');
    if (threw)
        throw std::runtime_error(said.substr(1));
    if (said == "?") {
        threw = true;
        throw std::bad_alloc();
    }
    return QString::fromStdString(said);
}

} // namespace

void fuzzDecoderReply(FuzzBytes bytes)
{
    DecoderSocket socket;
    sayInMessages(socket, bytes);
    socket.hangUp();
    fence::Ready ready;
    const auto greeting = fence::hear(socket.programsEnd(), atOnce, ready);
    if (greeting == fence::Heard::Silence)
        qFatal("a decoder that hung up is waited for");
    if (greeting != fence::Heard::Message)
        return;
    fence::Reply reply;
    const auto heard = fence::hear(socket.programsEnd(), atOnce, firstRequest, reply);
    if (heard == fence::Heard::Silence)
        qFatal("a decoder that hung up is waited for");
    if (heard == fence::Heard::Message)
        checkHeard(reply);
}

void fuzzDecoderRequest(FuzzBytes bytes)
{
    fence::Request request;
    if (bytes.size() < sizeof(request))
        return;
    std::memcpy(&request, bytes.data(), sizeof(request));
    const FuzzBytes input = bytes.subspan(sizeof(request));
    constexpr std::uint64_t most = std::uint64_t(1) << 20;
    if (!fence::isSound(request) || request.memoryBytes > most)
        return;
    std::vector<std::uint8_t> memory(request.memoryBytes);
    std::copy_n(input.begin(), std::min(input.size(), memory.size()), memory.begin());
    const fence::Reply reply = fence::replyTo(request, memory, workOfAnyKind);
    if (threw && reply.verdict != fence::Verdict::Refused)
        qFatal("a decoder that failed says that it is done");
    // What a decoder says by itself its program takes for an answer.
    DecoderSocket socket;
    socket.say({reinterpret_cast<const std::uint8_t*>(&reply), sizeof(reply)});
    fence::Reply heard;
    if (fence::hear(socket.programsEnd(), atOnce, request.number, heard) != fence::Heard::Message)
        qFatal("a decoder's own reply is none");
    checkHeard(heard);
}

} // namespace test
