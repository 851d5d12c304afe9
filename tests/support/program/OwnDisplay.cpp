// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/OwnDisplay.h"

#include <QByteArray>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

namespace {

[[noreturn]] void giveUp(const char* why)
{
    std::fprintf(stderr, "no display for this test: %s\n", why);
    std::exit(1);
}

// The server writes the number it chose, and a line end, when it takes connections.
QByteArray numberFrom(int end)
{
    constexpr int patienceMs = 60000; // servers start slowly on a machine that builds beside
    QByteArray number;
    pollfd waiting{.fd = end, .events = POLLIN, .revents = 0};
    char letter = 0;
    while (poll(&waiting, 1, patienceMs) > 0 && read(end, &letter, 1) == 1) {
        if (letter == '\n')
            return number;
        number.append(letter);
    }
    return {};
}

} // namespace

OwnDisplay::OwnDisplay()
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        giveUp("no pipe");
    const pid_t parent = getpid();
    m_server = fork();
    if (m_server < 0)
        giveUp("no process");
    if (m_server == 0) {
        // Dies with the test, also when that is killed.
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
            _exit(1);
        const int silence = open("/dev/null", O_RDWR);
        dup2(silence, STDIN_FILENO);
        dup2(silence, STDOUT_FILENO);
        dup2(silence, STDERR_FILENO);
        constexpr int numberEnd = 3;
        if (ends[1] == numberEnd)
            fcntl(numberEnd, F_SETFD, 0);
        else
            dup2(ends[1], numberEnd);
        // Without -noreset it begins anew whenever its last client leaves.
        execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "2560x1440x24", "-nolisten",
            "tcp", "-noreset", static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    const QByteArray number = numberFrom(ends[0]);
    close(ends[0]);
    if (number.isEmpty())
        giveUp("Xvfb did not start; is it installed?");
    qputenv("DISPLAY", ':' + number);
    qputenv("QT_QPA_PLATFORM", "xcb");
    qunsetenv("WAYLAND_DISPLAY");
    qunsetenv("XAUTHORITY");
}

OwnDisplay::~OwnDisplay()
{
    kill(m_server, SIGTERM);
    waitpid(m_server, nullptr, 0);
}

} // namespace test
