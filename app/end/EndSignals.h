// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// While it lives, the signals that ask a program to end (SIGTERM, SIGINT, SIGHUP) do not end it:
/// each is told through a pipe, as one byte that is its number. What the parent has ignored (nohup)
/// stays ignored. One per process.
class EndSignals {
public:
    /// Whether reading waits for a signal, or returns at once where there is none.
    enum class Reading { Waits, ReturnsAtOnce };

    /// Where there is no pipe to be had, signals end the program as they always do.
    explicit EndSignals(Reading reading);
    ~EndSignals(); ///< stop()
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    [[nodiscard]] bool areTold() const { return m_ends[0] >= 0; }
    /// The end of the pipe that is read; −1: there is none.
    [[nodiscard]] int descriptor() const { return m_ends[0]; }
    /// The next signal; 0: there is none, or stop() was called. Any thread, one at a time.
    [[nodiscard]] int read() const;
    /// From now on signals end the program again; who waits in read() returns.
    void stop();

private:
    int m_ends[2] = {-1, -1}; ///< of the pipe: read, written
};

} // namespace app
