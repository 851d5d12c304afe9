// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// While an object of this class exists, the signals that ask a program to end (SIGTERM, SIGINT,
/// SIGHUP) do not end it: each is reported through a pipe, as one byte with the signal's number. A
/// signal that the parent has ignored (nohup) stays ignored. One per process.
class EndSignals {
public:
    /// Whether read() waits for a signal, or returns at once if there is none.
    enum class Reading { Waits, ReturnsAtOnce };

    /// If no pipe can be made, signals end the program as usual.
    explicit EndSignals(Reading reading);
    ~EndSignals(); ///< calls stop()
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    [[nodiscard]] bool areCaught() const { return m_ends[0] >= 0; }
    /// The reading end of the pipe; −1 if there is none.
    [[nodiscard]] int descriptor() const { return m_ends[0]; }
    /// The next signal; 0 if there is none, or stop() was called. Any thread, one at a time.
    [[nodiscard]] int read() const;
    /// Lets signals end the program again; a thread that waits in read() returns.
    void stop();

private:
    int m_ends[2] = {-1, -1}; ///< reading and writing end of the pipe
};

} // namespace app
