// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/fence/FenceProtocol.h"

#include <QString>
#include <QStringList>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include <sys/types.h>

namespace core {

/// How a decoder is started.
struct WorkerProgram {
    QString path; ///< executed as it is, never searched for
    QStringList arguments;
};

/// One decoder: a separate process behind a socket, with shared memory. It is not trusted: a
/// message of an unexpected form ends it. One thread at a time.
class WorkerProcess {
public:
    enum class Outcome {
        Done,
        Refused, ///< the input is at fault; a sentence says why
        Stopped, ///< the process ended, by itself or by its limits
        Killed, ///< another program ended it (SIGKILL)
        TooSlow,
        Nonsense, ///< its answer is invalid
        NoMemory, ///< no memory to share is available
    };
    struct Answer {
        Outcome outcome = Outcome::Done;
        Clause sentence{}; ///< for Refused
        std::span<const std::uint8_t> output{}; ///< for Done; valid until the next request
    };

    /// Starts a process and waits until it is ready. Null: it cannot be started, and @p why says
    /// why.
    [[nodiscard]] static std::unique_ptr<WorkerProcess> start(
        const WorkerProgram& program, std::chrono::milliseconds patience, Clause& why);
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    /// Ends the process at once.
    ~WorkerProcess();

    /// Sends @p input and waits for as much processor time as @p patience, however long that takes
    /// on a busy machine, but at most ten times as long. After any outcome except Done and Refused
    /// the process cannot be used any more.
    [[nodiscard]] Answer ask(std::span<const std::uint8_t> parameters,
        std::span<const std::uint8_t> input, std::size_t outputBytes,
        std::chrono::milliseconds patience);

    /// Whether it still runs and has sent nothing without a request.
    [[nodiscard]] bool isWaiting() const;
    /// Whether the kernel filters its system calls.
    [[nodiscard]] bool isFiltered() const { return m_filtered; }
    /// Size of the memory shared with the program, until it ends.
    [[nodiscard]] std::size_t sharedBytes() const { return m_memoryBytes; }
    [[nodiscard]] pid_t id() const { return m_process; }

private:
    WorkerProcess() = default;

    [[nodiscard]] bool makeEnds(int& theirSocket);
    [[nodiscard]] bool spawn(const WorkerProgram& program, int theirSocket);
    [[nodiscard]] bool share(std::size_t bytes);
    void allow(std::size_t inputBytes, std::size_t outputBytes, std::chrono::milliseconds patience);
    [[nodiscard]] Outcome howItEnded();
    void end();

    pid_t m_process = -1;
    int m_socket = -1;
    int m_memory = -1;
    std::uint8_t* m_bytes = nullptr;
    std::size_t m_memoryBytes = 0;
    std::size_t m_ownBytes = 0; ///< address space that the process itself needs
    std::uint32_t m_requests = 0;
    bool m_filtered = false;
};

} // namespace core
