// SPDX-License-Identifier: Apache-2.0
#include "core/fence/WorkerProcess.h"

#include <QByteArrayList>
#include <QFile>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace core {

namespace {

using namespace fence;
using std::chrono::milliseconds;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
#else
constexpr bool sanitized = false;
#endif

std::size_t inPages(std::size_t bytes)
{
    constexpr std::size_t page = 4096;
    return (bytes + page - 1) / page * page;
}

/// Address space of a process; 0: it is gone.
std::size_t addressSpace(pid_t process)
{
    QFile sizes(QStringLiteral("/proc/%1/statm").arg(process));
    if (!sizes.open(QIODevice::ReadOnly))
        return 0;
    return sizes.readLine().split(' ').value(0).toULongLong() * std::size_t(sysconf(_SC_PAGESIZE));
}

/// Nothing of the environment but where libraries lie, so that nothing in it changes what a decoder
/// does.
QByteArrayList environment()
{
    QByteArrayList all{"LANG=C.UTF-8"};
    for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
        if (const char* value = std::getenv(name))
            all.append(QByteArray(name) + '=' + value);
    }
    return all;
}

std::vector<char*> pointersTo(QByteArrayList& words)
{
    std::vector<char*> all;
    for (QByteArray& word : words)
        all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

/// The soft limit, which the process itself could raise if its filter let it.
void limit(pid_t process, decltype(RLIMIT_AS) resource, rlim_t value)
{
    rlimit both{};
    if (prlimit(process, resource, nullptr, &both) != 0)
        return;
    both.rlim_cur = std::min(value, both.rlim_max);
    prlimit(process, resource, &both, nullptr);
}

} // namespace

std::unique_ptr<WorkerProcess> WorkerProcess::start(
    const WorkerProgram& program, milliseconds patience, Clause& why)
{
    std::unique_ptr<WorkerProcess> made(new WorkerProcess);
    int theirSocket = -1;
    const bool spawned = made->makeEnds(theirSocket) && made->spawn(program, theirSocket);
    const int reason = errno;
    if (theirSocket >= 0)
        close(theirSocket);
    if (!spawned) {
        why = QString::fromLocal8Bit(std::strerror(reason));
        return nullptr;
    }
    Ready ready;
    const Heard heard = hear(made->m_socket, patience, ready);
    if (heard != Heard::Message) {
        why = heard == Heard::Silence ? Clause::saying("it does not answer")
                                      : Clause::saying("it is not Burin's");
        return nullptr;
    }
    made->m_filtered = ready.filtered == 1;
    made->m_ownBytes = addressSpace(made->m_process);
    return made;
}

WorkerProcess::~WorkerProcess()
{
    end();
    if (m_bytes != nullptr)
        munmap(m_bytes, m_memoryBytes);
    for (const int descriptor : {m_socket, m_memory}) {
        if (descriptor >= 0)
            close(descriptor);
    }
}

bool WorkerProcess::makeEnds(int& theirSocket)
{
    std::array<int, 2> ends{-1, -1};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return false;
    m_socket = ends[0];
    theirSocket = ends[1];
    m_memory = memfd_create("burin-frames", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    // Were it cut by the other side, reading it would end this one.
    return m_memory >= 0 && fcntl(m_memory, F_ADD_SEALS, F_SEAL_SHRINK) == 0;
}

bool WorkerProcess::spawn(const WorkerProgram& program, int theirSocket)
{
    QByteArrayList words{QFile::encodeName(program.path)};
    for (const QString& argument : program.arguments)
        words.append(argument.toLocal8Bit());
    QByteArrayList variables = environment();
    const std::vector<char*> argv = pointersTo(words);
    const std::vector<char*> envp = pointersTo(variables);

    // Moved out of the way first: one may already bear the number that the other is to get.
    const int socket = fcntl(theirSocket, F_DUPFD_CLOEXEC, memoryDescriptor + 1);
    const int memory = fcntl(m_memory, F_DUPFD_CLOEXEC, memoryDescriptor + 1);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, socket, socketDescriptor);
    posix_spawn_file_actions_adddup2(&actions, memory, memoryDescriptor);
    posix_spawn_file_actions_addclosefrom_np(&actions, memoryDescriptor + 1);
    // A signal that this program ignores or blocks would be ignored or blocked there, too.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const int failed = socket < 0 || memory < 0
        ? errno
        : posix_spawn(&m_process, argv.front(), &actions, &attributes, argv.data(), envp.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    for (const int descriptor : {socket, memory}) {
        if (descriptor >= 0)
            close(descriptor);
    }
    if (failed != 0)
        m_process = -1;
    errno = failed;
    return failed == 0;
}

bool WorkerProcess::share(std::size_t bytes)
{
    if (bytes <= m_memoryBytes)
        return true;
    if (m_bytes != nullptr)
        munmap(m_bytes, m_memoryBytes);
    m_bytes = nullptr;
    m_memoryBytes = 0;
    if (ftruncate(m_memory, off_t(bytes)) != 0)
        return false;
    void* mapped = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, m_memory, 0);
    if (mapped == MAP_FAILED)
        return false;
    m_bytes = static_cast<std::uint8_t*>(mapped);
    m_memoryBytes = bytes;
    return true;
}

bool WorkerProcess::isWaiting() const
{
    pollfd watched{.fd = m_socket, .events = POLLIN, .revents = 0};
    return poll(&watched, 1, 0) == 0;
}

/// What decoding so many bytes may take, and no more. The decoder cannot change it.
void WorkerProcess::allow(std::size_t inputBytes, std::size_t outputBytes, milliseconds patience)
{
    constexpr std::size_t always = std::size_t(192) << 20;
    // OpenJPEG holds 32 bits for every sample, several times; 8-bit pixels are the worst.
    const std::size_t work = always + 4 * inputBytes + 24 * outputBytes;
    if (!sanitized)
        limit(m_process, RLIMIT_AS, m_ownBytes + m_memoryBytes + work);
    clockid_t clock = 0;
    timespec used{};
    if (clock_getcpuclockid(m_process, &clock) != 0 || clock_gettime(clock, &used) != 0)
        return;
    // The kernel counts whole seconds; it ends the process also where this one is gone by then.
    const milliseconds until = milliseconds(used.tv_nsec / 1000000 + 999) + patience;
    limit(m_process, RLIMIT_CPU, rlim_t(used.tv_sec) + rlim_t(until.count() / 1000));
}

WorkerProcess::Answer WorkerProcess::ask(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> input, std::size_t outputBytes, milliseconds patience)
{
    const std::size_t outputAt = inPages(input.size());
    if (parameters.size() > longestParameters || !share(outputAt + inPages(outputBytes)))
        return {.outcome = Outcome::NoMemory};
    allow(input.size(), outputBytes, patience);
    std::copy(input.begin(), input.end(), m_bytes);
    Request request{.number = ++m_requests,
        .memoryBytes = m_memoryBytes,
        .inputBytes = input.size(),
        .outputAt = outputAt,
        .outputBytes = outputBytes,
        .parameterBytes = std::uint32_t(parameters.size())};
    std::copy(parameters.begin(), parameters.end(), request.parameters.begin());
    if (send(m_socket, &request, sizeof(request), MSG_NOSIGNAL) != ssize_t(sizeof(request)))
        return {.outcome = howItEnded()};
    Reply reply;
    switch (hear(m_socket, 10 * patience, request.number, reply)) {
    case Heard::Silence:
        end();
        return {.outcome = Outcome::TooSlow};
    case Heard::End:
        return {.outcome = howItEnded()};
    case Heard::Noise:
        return {.outcome = Outcome::Nonsense};
    case Heard::Message:
        break;
    }
    if (reply.verdict == Verdict::Refused)
        return {.outcome = Outcome::Refused, .sentence = sentenceOf(reply)};
    return {.outcome = Outcome::Done, .output = {m_bytes + outputAt, outputBytes}};
}

/// Its end of the socket is closed: it has ended, or will not be heard of again.
WorkerProcess::Outcome WorkerProcess::howItEnded()
{
    int status = 0;
    pid_t ended = 0;
    constexpr int tries = 200;
    for (int attempt = 0; attempt < tries && ended == 0; ++attempt) {
        ended = waitpid(m_process, &status, WNOHANG);
        if (ended == 0)
            poll(nullptr, 0, 5);
    }
    if (ended != m_process) {
        end();
        return Outcome::Stopped;
    }
    m_process = -1;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU)
        return Outcome::TooSlow;
    return signal == SIGKILL ? Outcome::Killed : Outcome::Stopped;
}

void WorkerProcess::end()
{
    if (m_process < 0)
        return;
    kill(m_process, SIGKILL);
    while (waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) { }
    m_process = -1;
}

} // namespace core
