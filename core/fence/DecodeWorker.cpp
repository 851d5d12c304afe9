// SPDX-License-Identifier: Apache-2.0
#include "core/fence/DecodeWorker.h"

#include "core/fence/FenceProtocol.h"
#include "core/fence/SystemCallFilter.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace core {

namespace {

using namespace fence;

void limit(decltype(RLIMIT_CORE) resource, rlim_t value)
{
    const rlimit both{.rlim_cur = value, .rlim_max = value};
    setrlimit(resource, &both);
}

/// What its parent does not limit from outside (WorkerProcess.cpp): memory and time depend on the
/// work.
void giveUpRights()
{
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NPROC, 0);
    // Those it has stay open.
    limit(RLIMIT_NOFILE, 0);
}

/// The memory that both see.
class SharedMemory {
public:
    [[nodiscard]] bool reach(std::size_t bytes)
    {
        if (bytes <= m_bytes)
            return true;
        if (m_begin != nullptr)
            munmap(m_begin, m_bytes);
        void* mapped =
            mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memoryDescriptor, 0);
        const bool good = mapped != MAP_FAILED;
        m_begin = good ? static_cast<std::uint8_t*>(mapped) : nullptr;
        m_bytes = good ? bytes : 0;
        return good;
    }
    [[nodiscard]] std::span<std::uint8_t> bytes() const { return {m_begin, m_bytes}; }

private:
    std::uint8_t* m_begin = nullptr;
    std::size_t m_bytes = 0;
};

QString carryOut(FencedWork work, const Request& request, std::span<std::uint8_t> memory)
{
    try {
        return work(std::span(request.parameters).first(request.parameterBytes),
            memory.first(request.inputBytes),
            memory.subspan(request.outputAt, request.outputBytes));
    } catch (const std::bad_alloc&) {
        return QStringLiteral("decoding it takes more memory than such an image may");
    } catch (const std::exception& exception) {
        const QString what = QString::fromLatin1(exception.what());
        return what.isEmpty() ? QStringLiteral("damaged pixel data") : what;
    }
}

} // namespace

fence::Reply fence::replyTo(const Request& request, std::span<std::uint8_t> memory, FencedWork work)
{
    const QString wrong = carryOut(work, request, memory);
    Reply reply{.number = request.number};
    reply.verdict = wrong.isEmpty() ? Verdict::Done : Verdict::Refused;
    const QByteArray sentence = wrong.toUtf8();
    reply.sentenceBytes =
        std::uint32_t(std::min<std::size_t>(std::size_t(sentence.size()), longestSentence));
    std::memcpy(reply.sentence.data(), sentence.constData(), reply.sentenceBytes);
    return reply;
}

int runDecodeWorker(void (*prepare)(), FencedWork work)
{
    prepare();
    giveUpRights();
    const bool filtered = filterSystemCalls(socketDescriptor);
    const Ready ready{.filtered = filtered ? 1u : 0u};
    if (write(socketDescriptor, &ready, sizeof(ready)) != ssize_t(sizeof(ready)))
        _exit(1);
    SharedMemory memory;
    Request request;
    while (read(socketDescriptor, &request, sizeof(request)) == ssize_t(sizeof(request))) {
        if (!isSound(request) || !memory.reach(request.memoryBytes))
            _exit(1);
        const Reply reply = replyTo(request, memory.bytes(), work);
        if (write(socketDescriptor, &reply, sizeof(reply)) != ssize_t(sizeof(reply)))
            _exit(1);
    }
    // Whatever else the program would do at its end is stopped by the filter.
    _exit(0);
}

} // namespace core
