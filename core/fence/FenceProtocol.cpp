// SPDX-License-Identifier: Apache-2.0
#include "core/fence/FenceProtocol.h"

#include <algorithm>
#include <cerrno>

#include <poll.h>
#include <sys/socket.h>

namespace core::fence {

namespace {

Heard hearMessage(int socket, std::chrono::milliseconds patience, void* message, std::size_t size)
{
    using std::chrono::milliseconds;
    const auto until = std::chrono::steady_clock::now() + patience;
    pollfd watched{.fd = socket, .events = POLLIN, .revents = 0};
    while (true) {
        const auto left =
            std::chrono::duration_cast<milliseconds>(until - std::chrono::steady_clock::now());
        const int woken = poll(&watched, 1, int(std::max<std::int64_t>(0, left.count())));
        if (woken < 0 && errno == EINTR)
            continue;
        if (woken <= 0)
            return Heard::Silence;
        const ssize_t got = recv(socket, message, size, MSG_DONTWAIT | MSG_TRUNC);
        if (got < 0 && (errno == EINTR || errno == EAGAIN))
            continue;
        if (got <= 0)
            return Heard::End;
        return std::size_t(got) == size ? Heard::Message : Heard::Noise;
    }
}

} // namespace

Heard hear(int socket, std::chrono::milliseconds patience, Ready& ready)
{
    const Heard heard = hearMessage(socket, patience, &ready, sizeof(ready));
    return heard == Heard::Message && ready.magic != magic ? Heard::Noise : heard;
}

Heard hear(int socket, std::chrono::milliseconds patience, std::uint32_t number, Reply& reply)
{
    const Heard heard = hearMessage(socket, patience, &reply, sizeof(reply));
    const bool sound = reply.magic == magic && reply.number == number
        && (reply.verdict == Verdict::Done || reply.verdict == Verdict::Refused)
        && reply.sentenceBytes <= longestSentence;
    return heard == Heard::Message && !sound ? Heard::Noise : heard;
}

Clause sentenceOf(const Reply& reply)
{
    QString text = QString::fromUtf8(reply.sentence.data(),
        qsizetype(std::min<std::size_t>(reply.sentenceBytes, longestSentence)));
    for (QChar& letter : text) {
        // To Qt these are printable.
        const bool endsLine = letter == QChar::LineSeparator || letter == QChar::ParagraphSeparator;
        if (!letter.isPrint() || endsLine)
            letter = QLatin1Char('?');
    }
    return text.isEmpty() ? Clause::saying("damaged pixel data") : Clause(text);
}

bool isSound(const Request& request)
{
    return request.magic == magic && request.parameterBytes <= longestParameters
        && request.inputBytes <= request.outputAt && request.outputAt <= request.memoryBytes
        && request.outputBytes <= request.memoryBytes - request.outputAt;
}

} // namespace core::fence
