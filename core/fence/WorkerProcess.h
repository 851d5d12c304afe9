// SPDX-License-Identifier: Apache-2.0
#pragma once

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
    QString path; ///< which is executed as it is, never searched for
    QStringList arguments;
};

/// One decoder: a process of its own behind a socket, and memory that both see. What it says is
/// believed no further than it goes: a message of another form is the end of it. One thread at a
/// time.
class WorkerProcess {
public:
    enum class Outcome {
        Done,
        Refused, ///< the bytes are at fault; a sentence says how
        Stopped, ///< the process ended, by itself or by its limits
        Killed, ///< somebody else ended it (SIGKILL)
        TooSlow,
        Nonsense, ///< what it said is no answer
        NoMemory, ///< there is none to hand bytes over
    };
    struct Answer {
        Outcome outcome = Outcome::Done;
        QString sentence{}; ///< of Refused
        std::span<const std::uint8_t> output{}; ///< of Done; until the next request
    };

    /// Starts it and waits until it is ready. Null: it cannot be started; @p why says why.
    [[nodiscard]] static std::unique_ptr<WorkerProcess> start(
        const WorkerProgram& program, std::chrono::milliseconds patience, QString& why);
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    /// Ends it at once.
    ~WorkerProcess();

    /// Hands over @p input and waits: for as much time of a processor as @p patience, however long
    /// that takes on a machine that is busy (but no longer than ten times of it). After any outcome
    /// but Done and Refused it is of no more use.
    [[nodiscard]] Answer ask(std::span<const std::uint8_t> parameters,
        std::span<const std::uint8_t> input, std::size_t outputBytes,
        std::chrono::milliseconds patience);

    /// It has not ended, nor said anything unasked.
    [[nodiscard]] bool isWaiting() const;
    /// The kernel stops its system calls.
    [[nodiscard]] bool isFiltered() const { return m_filtered; }
    /// Bytes that it and the program share, until it ends.
    [[nodiscard]] std::size_t sharedBytes() const { return m_memoryBytes; }
    [[nodiscard]] pid_t id() const { return m_process; }

private:
    WorkerProcess() = default;

    [[nodiscard]] bool makeEnds(int& theirSocket);
    [[nodiscard]] bool spawn(const WorkerProgram& program, int theirSocket);
    [[nodiscard]] bool share(std::size_t bytes);
    void allow(std::size_t inputBytes, std::size_t outputBytes, std::chrono::milliseconds patience);
    enum class Heard { Message, Silence, End, Noise };
    [[nodiscard]] Heard hear(void* message, std::size_t size, std::chrono::milliseconds patience);
    [[nodiscard]] Outcome howItEnded();
    void end();

    pid_t m_process = -1;
    int m_socket = -1;
    int m_memory = -1;
    std::uint8_t* m_bytes = nullptr;
    std::size_t m_memoryBytes = 0;
    std::size_t m_ownBytes = 0; ///< of address space that it takes by itself
    std::uint32_t m_requests = 0;
    bool m_filtered = false;
};

} // namespace core
